#include "host/output/qoi_writer.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "tests/support/random_pictures.h"

namespace {

using Pixel = std::array<std::uint8_t, 4>;

// As the specification says, chunk by chunk. Counts the chunks of each kind.
struct Decoder {
  explicit Decoder(std::string_view file) : rest(file) {}

  std::string_view rest;
  Pixel pixel{0, 0, 0, 255};
  std::array<Pixel, 64> seen{};
  std::array<int, 6> kinds{};  // index, small step, step, run, RGB, RGBA

  std::uint8_t byte() {
    REQUIRE_FALSE(rest.empty());
    const auto first = static_cast<std::uint8_t>(rest.front());
    rest.remove_prefix(1);
    return first;
  }

  std::uint32_t number() {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8U | byte();
    return value;
  }

  void change(int red, int green, int blue) {
    pixel[0] = static_cast<std::uint8_t>(pixel[0] + red);
    pixel[1] = static_cast<std::uint8_t>(pixel[1] + green);
    pixel[2] = static_cast<std::uint8_t>(pixel[2] + blue);
  }

  // Returns how often the pixel comes.
  int chunk() {
    const int first = byte();
    int times = 1;
    if (first >= 0xFE) {
      for (std::size_t k = 0; k < (first == 0xFF ? 4 : 3); ++k) pixel[k] = byte();
      ++kinds[first == 0xFF ? 5 : 4];
    } else if (first >= 0xC0) {
      times = (first & 0x3F) + 1;
      ++kinds[3];
    } else if (first >= 0x80) {
      const int green = (first & 0x3F) - 32, second = byte();
      change(green - 8 + (second >> 4), green, green - 8 + (second & 0x0F));
      ++kinds[2];
    } else if (first >= 0x40) {
      change((first >> 4 & 3) - 2, (first >> 2 & 3) - 2, (first & 3) - 2);
      ++kinds[1];
    } else {
      pixel = seen[static_cast<std::size_t>(first)];
      ++kinds[0];
    }
    seen[static_cast<std::size_t>(pixel[0] * 3 + pixel[1] * 5 + pixel[2] * 7 + pixel[3] * 11) %
         64] = pixel;
    return times;
  }
};

}  // namespace

TEST_CASE("a QOI decodes to the same picture, and has chunks of every kind") {
  std::array<int, 6> kinds{};
  for (const host::RgbaPicture& picture : test::random_pictures(5)) {
    const std::string file = host::qoi_of(picture);
    REQUIRE(file.starts_with("qoif"));
    Decoder decoder(std::string_view(file).substr(4));
    CHECK_EQ(decoder.number(), static_cast<std::uint32_t>(picture.width));
    CHECK_EQ(decoder.number(), static_cast<std::uint32_t>(picture.height));
    CHECK_EQ(decoder.byte(), 4);
    CHECK_EQ(decoder.byte(), 0);
    std::vector<std::uint8_t> bytes;
    while (bytes.size() < picture.bytes.size()) {
      const int times = decoder.chunk();
      for (int i = 0; i < times; ++i)
        bytes.insert(bytes.end(), decoder.pixel.begin(), decoder.pixel.end());
    }
    CHECK(bytes == picture.bytes);
    CHECK_EQ(decoder.rest, std::string_view("\0\0\0\0\0\0\0\x01", 8));
    CHECK_LE(file.size(), picture.bytes.size() / 4 * 5 + 22);
    for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] += decoder.kinds[i];
  }
  for (const int count : kinds) CHECK_GT(count, 0);
}
