#include "core/slices/height_ranges.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using core::HeightRange;
using core::Length;
using core::Settings;

namespace {

Settings with(std::vector<std::string> lines) {
  Settings settings;
  settings.height_range = std::move(lines);
  return settings;
}

std::string error_of(const Settings& settings) {
  const auto ranges = core::height_ranges(settings);
  return ranges.ok() ? "" : ranges.error().message;
}

void check_says(const std::string& error, const std::string& words) {
  CAPTURE(error);
  CAPTURE(words);
  CHECK(error.find(words) != std::string::npos);
}

}  // namespace

TEST_CASE("a line is two heights and the layers' height, exact to the unit") {
  for (const char* text : {"10-12.5 0.1", " 10 - 12.5\t0.1 ", "10.0000-12.50 .1"}) {
    CAPTURE(text);
    const auto range = core::read_height_range(text);
    REQUIRE(range.ok());
    CHECK_EQ(range.value().from, Length::from_units(100'000));
    CHECK_EQ(range.value().to, Length::from_units(125'000));
    CHECK_EQ(range.value().height, Length::from_units(1'000));
    CHECK_EQ(range.value().layers(), 25);
  }
  for (const char* text : {"", "10", "10-12.5", "10 12.5 0.1", "10-12.5 0.1 x", "10-12.5 a",
                           "-10-12.5 0.1", "10-12.5 0.10001", "1e1-12 0.1", "10-12,5 0.1"}) {
    CAPTURE(text);
    const auto range = core::read_height_range(text);
    REQUIRE_FALSE(range.ok());
    check_says(range.error().message, "is not understood: expected \"FROM-TO HEIGHT\"");
  }
  check_says(core::read_height_range("12-12 0.1").error().message, "ends at 12 mm, not above 12");
  check_says(core::read_height_range("1-2 0.005").error().message, "0.005 mm: expected 0.01 to 2");
  check_says(core::read_height_range("1-9 2.1").error().message, "2.1 mm: expected 0.01 to 2");
}

TEST_CASE("ranges come in any order; one that begins within the first layer begins at its top") {
  Settings settings = with({"10-12.55 0.1", "0-5 0.15"});
  settings.first_layer_height = Length::from_mm(0.3);
  const auto ranges = core::height_ranges(settings);
  REQUIRE(ranges.ok());
  REQUIRE_EQ(ranges.value().size(), 2);
  const HeightRange& low = ranges.value()[0];
  CHECK_EQ(low.line, 2);
  CHECK_EQ(low.from, Length::from_mm(0.3));
  CHECK_EQ(low.layers(), 32);
  CHECK_EQ(low.end(), Length::from_mm(5.1));
  // The last layer covers what is left, and reaches above it.
  CHECK_EQ(ranges.value()[1].layers(), 26);
  CHECK_EQ(ranges.value()[1].end(), Length::from_mm(12.6));
}

TEST_CASE("errors name the line and the cause") {
  check_says(error_of(with({"1-2 0.1", "3-4"})), "height_range, line 2: \"3-4\" is not understood");
  check_says(error_of(with({"10-12 0.1", "11-13 0.2"})),
             "height_range, line 2: it begins at 11 mm, within line 1, whose layers end at 12 mm");
  check_says(error_of(with({"10-12.05 0.1", "12.05-13 0.2"})),
             "line 2: it begins at 12.05 mm, within line 1, whose layers end at 12.1 mm");
  check_says(error_of(with({"0-0.2 0.1"})),
             "line 1: it ends at 0.2 mm, within the first layer of 0.2 mm");
  check_says(error_of(with({"20-21 0.1", "10-19.95 0.05"})),
             "line 1: it begins at 20 mm, 0.05 mm above line 2, which ends at 19.95 mm: too little "
             "for a layer; begin at 19.95 mm, or at 20.05 mm or above");
  check_says(error_of(with({"0.25-1 0.1"})), "0.05 mm above the first layer, which ends at 0.2");
  CHECK_EQ(error_of(with({"0.3-1 0.1", "1-2 0.05", "2.1-3 0.3"})), "");
  // Adaptive layers are at least layer_height_min high.
  Settings settings = with({"0.235-1 0.1"});
  settings.adaptive_layer_height = true;
  CHECK_EQ(error_of(settings), "");
  settings.height_range = {"0.234-1 0.1"};
  check_says(error_of(settings), "too little for a layer");
  check_says(error_of(with(std::vector<std::string>(257, "1-2 0.1"))), "more than 256 lines");
}
