#include "host/settings/prusa_bed.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "host/settings/settings_text.h"

namespace {

// A regular outline of so many corners around a middle.
std::string outline(int corners, double radius, double x, double y) {
  std::string text;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    text += (i > 0 ? "," : "") + host::write_number(x + radius * std::cos(angle)) + "x" +
            host::write_number(y + radius * std::sin(angle));
  }
  return text;
}

}  // namespace

TEST_CASE("a rectangle along the axes, anywhere, in any order, with points on its edges") {
  for (const char* text :
       {"-3x-3,225x-3,225x225,-3x225", "225x225,-3x225,-3x-3,225x-3", "-3x225,225x225,225x-3,-3x-3",
        "-3x-3,0x-3,225x-3,225x225,-3x225", "-3x-3,225x-3,225x225,-3x225,-3x-3"}) {
    CAPTURE(text);
    const auto bed = host::rectangular_bed(text);
    REQUIRE(bed);
    CHECK_EQ(bed->left, -3);
    CHECK_EQ(bed->front, -3);
    CHECK_EQ(bed->width, 228);
    CHECK_EQ(bed->depth, 228);
  }
  for (const char* text :
       {"", "round", "0x0", "0x0,5x0", "0x0,5x0,5x5", "0x0,5x0,5x5,0x4", "0x0,5x5,5x0,0x5",
        "0x0,0x0,0x0,0x0", "0x0,5x0,5x5,0xnan", "0x0,5x0,5x5,0x5,,", "0,5,5,0"}) {
    CAPTURE(text);
    CHECK_FALSE(host::rectangular_bed(text));
  }
}

TEST_CASE("the rectangle within another bed lies within it, and is as large as can be") {
  for (const int corners : {6, 8, 72}) {
    CAPTURE(corners);
    const std::string text = outline(corners, 90, 10, -5);
    CHECK_FALSE(host::rectangular_bed(text));
    const auto bed = host::rectangle_within_bed(text);
    REQUIRE(bed);
    const double right = bed->left + bed->width - 10, back = bed->front + bed->depth + 5;
    CHECK_LT(std::hypot(right, back), 90);
    CHECK_LT(std::hypot(bed->left - 10, bed->front + 5), 90);
    CHECK_GT(bed->width * bed->depth, 0.4 * std::numbers::pi * 90 * 90);
  }
  CHECK_FALSE(host::rectangle_within_bed("0x0,9x0,1x1,0x9"));
  CHECK_FALSE(host::rectangle_within_bed("round"));
  CHECK_FALSE(host::rectangle_within_bed("0x0,1x1,2x2"));
}
