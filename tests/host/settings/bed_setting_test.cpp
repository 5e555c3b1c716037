#include "host/settings/bed_setting.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "host/settings/settings_table.h"
#include "host/settings/settings_text.h"

using core::Length;

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
    host::PrintSettings settings;
    REQUIRE(host::set_setting(settings, "bed_shape", text).ok());
    CHECK(settings.bed_shape.empty());
    CHECK_EQ(settings.bed_origin_x.mm(), -3);
    CHECK_EQ(settings.bed_origin_y.mm(), -3);
    CHECK_EQ(settings.bed_x.mm(), 228);
    CHECK_EQ(settings.bed_y.mm(), 228);
  }
}

TEST_CASE("an outline is kept, and reads back") {
  for (const int corners : {3, 6, 8, 72}) {
    CAPTURE(corners);
    const std::string text = outline(corners, 90, 10, -5);
    host::PrintSettings settings, again;
    REQUIRE(host::set_setting(settings, "bed_shape", text).ok());
    CHECK_EQ(settings.bed_shape.size(), corners);
    CHECK(host::validate_settings(settings).ok());
    for (const host::SettingRow& row : host::describe_settings(settings)) {
      REQUIRE(host::set_setting(again, row.key, row.value).ok());
    }
    CHECK(again.bed_shape == settings.bed_shape);
    CHECK_EQ(again.bed_x, settings.bed_x);
    CHECK_EQ(again.bed_origin_y, settings.bed_origin_y);
  }
}

TEST_CASE("what is no outline is refused, and says why") {
  const auto cause = [](const std::string& text) {
    const auto read = host::read_bed_shape(text);
    REQUIRE_FALSE(read.ok());
    return read.error().message;
  };
  const std::pair<const char*, const char*> kBad[] = {
      {"round", "no corner"},          {"0x0", "three corners"},
      {"0x0,5x0", "three corners"},    {"0x0,5x5,5x0,0x5", "crosses"},
      {"0x0,0x0,0x0,0x0", "three"},    {"0x0,5x0,5x5,0xnan", "nan"},
      {"0x0,5x0,5x5,0x5,,", "corner"}, {"0x0,5x0,5x5,0x5,", "missing"},
      {"0,5,5,0", "no corner"},        {"0x0,250x0,250x0.5,0x0.5", "bed_y"},
      {"0x0,1x1,2x2", "three"},        {"0x0,10x0,10x10,5x0,0x10", "touches"},
      {"0x0,9e9x0,9x9", "farther"},    {"1x", "a number is missing"}};
  for (const auto& [bad, word] : kBad) {
    const auto& text = bad;
    CAPTURE(text);
    CHECK_NE(cause(text).find(word), std::string::npos);
  }
  CHECK_NE(cause(outline(1'001, 90, 0, 0)).find("1000 corners"), std::string::npos);
  CHECK(host::read_bed_shape("rectangle").value().empty());
}

TEST_CASE("sides make the bed a rectangle, the origin moves its outline") {
  host::PrintSettings settings;
  REQUIRE(host::set_setting(settings, "bed_shape", outline(72, 100, 0, 0)).ok());
  REQUIRE(host::set_setting(settings, "bed-origin-x", "0").ok());
  CHECK_EQ(settings.bed_shape.size(), 72);
  CHECK_EQ(settings.bed_shape.front().x, 2'000'000);
  CHECK_EQ(settings.bed_shape.front().y, 0);
  // The same width says nothing new.
  REQUIRE(host::set_setting(settings, "bed_x", "200").ok());
  CHECK_EQ(settings.bed_shape.size(), 72);
  REQUIRE(host::set_setting(settings, "bed_x", "150").ok());
  CHECK(settings.bed_shape.empty());
  REQUIRE(host::set_setting(settings, "bed_shape", outline(72, 100, 0, 0)).ok());
  REQUIRE(host::set_setting(settings, "park_x", "1").ok());
  REQUIRE(host::set_setting(settings, "park_y", "1").ok());
  CHECK_FALSE(host::validate_settings(settings).ok());
  REQUIRE(host::set_setting(settings, "bed_shape", "rectangle").ok());
  CHECK(host::validate_settings(settings).ok());
}
