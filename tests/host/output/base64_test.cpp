#include "host/output/base64.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "tests/support/random_regions.h"

using host::base64_of;

namespace {

// By the definition: each letter gives six bits; what is left in the end is nothing.
std::string bytes_of(const std::string& text) {
  const std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bits;
  for (const char letter : text) {
    if (letter == '=') break;
    const std::size_t value = letters.find(letter);
    REQUIRE_NE(value, std::string_view::npos);
    for (int bit = 5; bit >= 0; --bit) bits += (value >> bit & 1U) != 0 ? '1' : '0';
  }
  std::string bytes;
  for (std::size_t at = 0; at + 8 <= bits.size(); at += 8) {
    bytes += static_cast<char>(std::stoi(bits.substr(at, 8), nullptr, 2));
  }
  return bytes;
}

}  // namespace

TEST_CASE("the vectors of RFC 4648") {
  CHECK_EQ(base64_of(""), "");
  CHECK_EQ(base64_of("f"), "Zg==");
  CHECK_EQ(base64_of("fo"), "Zm8=");
  CHECK_EQ(base64_of("foo"), "Zm9v");
  CHECK_EQ(base64_of("foob"), "Zm9vYg==");
  CHECK_EQ(base64_of("fooba"), "Zm9vYmE=");
  CHECK_EQ(base64_of("foobar"), "Zm9vYmFy");
  CHECK_EQ(base64_of("\xFB\xFF\xFE"), "+//+");
}

TEST_CASE("any bytes come back") {
  constexpr unsigned kSeed = 11;
  CAPTURE(kSeed);
  test::Random random(kSeed);
  for (int size = 0; size < 200; ++size) {
    std::string bytes;
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(random.integer(0, 255));
    const std::string text = base64_of(bytes);
    CHECK_EQ(text.size() % 4, 0);
    CHECK_EQ(bytes_of(text), bytes);
  }
}
