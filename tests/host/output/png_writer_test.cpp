#include "host/output/png_writer.h"

#include <doctest/doctest.h>
#include <zlib.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "tests/support/random_pictures.h"

namespace {

// By the definition, bit by bit (RFC 2083, 15).
std::uint32_t crc_of(std::string_view bytes) {
  std::uint32_t crc = ~0U;
  for (const char byte : bytes) {
    crc ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  REQUIRE_GE(bytes.size(), at + 4);
  std::uint32_t number = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    number = number << 8U | static_cast<std::uint8_t>(bytes[i]);
  return number;
}

host::RgbaPicture decoded(std::string_view file) {
  REQUIRE(file.starts_with("\x89PNG\r\n\x1A\n"));
  host::RgbaPicture picture;
  std::string packed, order;
  for (std::size_t at = 8; at < file.size();) {
    const std::size_t size = number_at(file, at);
    const std::string_view type = file.substr(at + 4, 4), content = file.substr(at + 8, size);
    CHECK_EQ(number_at(file, at + 8 + size), crc_of(file.substr(at + 4, size + 4)));
    order += type;
    if (type == "IHDR") {
      picture.width = static_cast<int>(number_at(content, 0));
      picture.height = static_cast<int>(number_at(content, 4));
      CHECK_EQ(content.substr(8), std::string_view("\x08\x06\0\0\0", 5));
    }
    if (type == "IDAT") packed += content;
    at += size + 12;
  }
  CHECK_EQ(order, "IHDRIDATIEND");
  const auto row_size = static_cast<std::size_t>(picture.width) * 4 + 1;
  std::string rows(row_size * static_cast<std::size_t>(picture.height) + 1, '\0');
  uLongf size = static_cast<uLongf>(rows.size());
  const int done = uncompress(reinterpret_cast<Bytef*>(rows.data()), &size,
                              reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  REQUIRE_EQ(done, Z_OK);
  REQUIRE_EQ(size, rows.size() - 1);
  for (std::size_t at = 0; at < size; at += row_size) {
    CHECK_EQ(rows[at], '\0');
    picture.bytes.insert(picture.bytes.end(), rows.data() + at + 1, rows.data() + at + row_size);
  }
  return picture;
}

}  // namespace

TEST_CASE("a PNG decodes to the same picture") {
  for (const host::RgbaPicture& picture : test::random_pictures(3)) {
    const host::RgbaPicture again = decoded(host::png_of(picture));
    CHECK_EQ(again.width, picture.width);
    CHECK_EQ(again.height, picture.height);
    CHECK(again.bytes == picture.bytes);
  }
}
