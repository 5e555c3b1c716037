#include "tests/support/random_pictures.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "tests/support/random_regions.h"

namespace test {

std::vector<host::RgbaPicture> random_pictures(unsigned seed) {
  Random random(seed);
  std::vector<host::RgbaPicture> pictures;
  for (const auto& [width, height] :
       {std::array{1, 1}, {1, 9}, {63, 1}, {16, 16}, {220, 124}, {61, 62}, {300, 300}}) {
    host::RgbaPicture picture{width, height, {}};
    std::array<std::uint8_t, 4> pixel{};
    int left = 0, kind = 0;
    for (int i = 0; i < width * height; ++i, --left) {
      if (left <= 0) {
        left = random.integer(1, 200);
        kind = random.integer(0, 4);
      }
      // 0: as it is; 1: noise; 2: opacity, too; 3, 4: a small step.
      for (std::size_t k = 0; k < (kind == 2 ? 4 : 3); ++k) {
        const int least = kind == 3 ? -1 : -9;
        const int step = kind == 0   ? 0
                         : kind <= 2 ? random.integer(0, 255)
                                     : random.integer(least, 1);
        pixel[k] = static_cast<std::uint8_t>(pixel[k] + step);
      }
      picture.bytes.insert(picture.bytes.end(), pixel.begin(), pixel.end());
    }
    pictures.push_back(picture);
  }
  return pictures;
}

}  // namespace test
