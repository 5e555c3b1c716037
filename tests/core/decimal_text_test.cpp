#include "core/decimal_text.h"

#include <doctest/doctest.h>

#include <string_view>

using core::read_decimal;

TEST_CASE("decimals are read exactly, or not at all") {
  CHECK_EQ(read_decimal("12.4", 2, 10'000), 1'240);
  CHECK_EQ(read_decimal("12", 0, 12), 12);
  CHECK_EQ(read_decimal(".5", 1, 10), 5);
  CHECK_EQ(read_decimal("5.", 1, 50), 50);
  CHECK_EQ(read_decimal("1.2300", 2, 1'000), 123);
  CHECK_EQ(read_decimal("0.0001", 4, 1), 1);
  for (const char* text :
       {"", ".", "1.234", "-1", "+1", "1e2", "1,2", "1.2.3", " 1", "1 ", "101"}) {
    CAPTURE(text);
    CHECK_FALSE(read_decimal(text, 2, 10'000).has_value());
  }
}

TEST_CASE("words are taken off a line one by one") {
  std::string_view line = "  M117  half \t done ";
  CHECK_EQ(core::take_word(line), "M117");
  CHECK_EQ(line, "half \t done");
  CHECK_EQ(core::take_word(line), "half");
  CHECK_EQ(core::take_word(line), "done");
  CHECK_EQ(core::take_word(line), "");
  CHECK_EQ(core::without_blanks(" \t "), "");
}
