// Lines of support_height_range, and which heights they are about.
#include "core/supports/support_heights.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using core::Length;
using core::Settings;
using core::SupportHeights;

namespace {

std::string error_of(std::vector<std::string> lines) {
  Settings settings;
  settings.support_height_range = std::move(lines);
  const auto ranges = core::support_ranges(settings);
  return ranges.ok() ? "" : ranges.error().message;
}

bool says(const std::string& error, const std::string& words) {
  CAPTURE(error);
  return error.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("a range holds from its beginning up to below its end") {
  Settings settings;
  settings.support_height_range = {"10-12.5 off", "0-1 off", "12.5-12.5001 on"};
  const SupportHeights heights(settings);
  for (const double off : {0.0, 0.9999, 10.0, 12.4999}) {
    CAPTURE(off);
    CHECK_FALSE(heights.hold_at(Length::from_mm(off)));
  }
  for (const double on : {1.0, 5.0, 9.9999, 12.5, 12.5001, 1e6}) {
    CAPTURE(on);
    CHECK(heights.hold_at(Length::from_mm(on)));
  }
  settings.support_auto = false;
  const SupportHeights none(settings);
  CHECK_FALSE(none.hold_at(Length::from_mm(5)));
  CHECK(none.hold_at(Length::from_mm(12.5)));
  CHECK_FALSE(none.hold_at(Length::from_mm(12.5001)));
  CHECK(heights.hold_anywhere());
  CHECK(none.hold_anywhere());
  settings.support_height_range = {"0-20 off"};
  CHECK_FALSE(SupportHeights(settings).hold_anywhere());
  settings.support_auto = true;
  CHECK(SupportHeights(settings).hold_anywhere());
}

TEST_CASE("what is no range is refused, with its line and what is expected") {
  CHECK_EQ(error_of({"0-20 off", "20-40.5 on"}), "");
  for (const std::string text : {"", "20 off", "0-20", "0-20 maybe", "0-20 off 3", "a-20 off",
                                 "0--20 off", "0-20.00001 off", "0-1e3 on"}) {
    CAPTURE(text);
    const std::string error = error_of({"1-2 on", text});
    CHECK(says(error, "line 2"));
    CHECK(says(error, "FROM-TO off"));
  }
  CHECK(says(error_of({"5-5 on"}), "ends below"));
  CHECK(says(error_of({"10-20 on", "0-1 off", "19.9999-30 on"}), "lines 1 and 3 overlap"));
  CHECK(says(error_of(std::vector<std::string>(257, "0-1 on")), "more than 256 lines"));
}
