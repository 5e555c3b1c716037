// A picture of pixels, from the top left, row by row: red, green, blue, opacity, a byte each. The
// colours are not multiplied by the opacity.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace host {

struct RgbaPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;  // 4 · width · height
};

}  // namespace host
