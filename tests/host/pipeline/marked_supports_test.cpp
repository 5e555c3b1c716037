// Whole prints of parts in which people have marked where supports are to be.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/host/whole_print.h"
#include "tests/support/marked_files.h"
#include "tests/support/part_folder.h"

using core::Length;
using core::Road;
using core::RoadKind;
using print_test::print;
using print_test::Printed;
using test::MarkedBody;

namespace {

// Parts begin at 1, 1 in their file.
constexpr double kPlace_mm = 5, kShift_mm = kPlace_mm - 1;

core::Settings supported() {
  core::Settings settings;
  settings.bed_x = settings.bed_y = Length::from_mm(80);
  settings.centre = false;
  settings.part_x = settings.part_y = Length::from_mm(kPlace_mm);
  settings.supports = core::SupportPlace::kEverywhere;
  settings.support_base_expansion = Length();
  settings.arcs = core::ArcUse::kOff;
  return settings;
}

// The extent of all roads of supports, in the file's coordinates, mm.
struct Extent {
  double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;

  [[nodiscard]] bool empty() const { return low_x > high_x; }
};

Extent supports_of(const Printed& printed) {
  REQUIRE_EQ(printed.error, "");
  Extent extent;
  for (const auto& roads : printed.roads) {
    for (const Road& road : roads) {
      if (road.kind != RoadKind::kSupport && road.kind != RoadKind::kSupportInterface) continue;
      for (const core::Point at : road.points) {
        const double x = at.x / 1e4 - kShift_mm, y = at.y / 1e4 - kShift_mm;
        extent.low_x = std::min(extent.low_x, x);
        extent.high_x = std::max(extent.high_x, x);
        extent.low_y = std::min(extent.low_y, y);
        extent.high_y = std::max(extent.high_y, y);
      }
    }
  }
  return extent;
}

Extent supports_of(const std::vector<MarkedBody>& bodies, const core::Settings& settings) {
  const test::PartFolder folder;
  return supports_of(print(settings, folder.add_text("part.3mf", test::prusa_threemf(bodies))));
}

std::int64_t told(const Printed& printed) {
  std::int64_t count = 0;
  for (std::size_t kind = 0; kind < core::kHangingKinds; ++kind) {
    count += printed.statistics.hanging.of(static_cast<core::HangingKind>(kind)).count;
  }
  return count;
}

MarkedBody marked_block(const std::string& type, double y, double depth) {
  return {parts::box({-5, y, -1}, 60, depth, 40), type};
}

// Whether the centre lines of supports reach over this stretch, and not beyond it.
void check_depth(const Extent& extent, double low, double high) {
  // Half a road; paint reaches a little farther, and narrow pieces are widened.
  CHECK_LT(std::abs(extent.low_y - low - 0.1), 0.16);
  CHECK_LT(std::abs(high - 0.1 - extent.high_y), 0.16);
}

}  // namespace

TEST_CASE("a gentle slope is held where it is enforced, by a body or by paint") {
  const parts::Part ramp = parts::ramp(30, 10);
  const core::Settings settings = supported();
  CHECK(supports_of({{ramp, "ModelPart"}}, settings).empty());
  const MarkedBody enforcer = marked_block("SupportEnforcer", 6, 7);
  core::Settings by_hand = settings;
  by_hand.support_auto = false;
  for (const core::Settings& either : {settings, by_hand}) {
    const Extent extent = supports_of({{ramp, "ModelPart"}, enforcer}, either);
    check_depth(extent, 6, 13);
    // Out to where the slope ends, up to the gap over the topmost.
    CHECK_GT(extent.high_x, 11 + 10 * std::tan(30 * 3.14159 / 180) - 0.6);
    const Extent painted =
        supports_of({{ramp, "ModelPart", [](std::int64_t) { return "4"; }}}, either);
    check_depth(painted, 1, 21);
    CHECK_EQ(painted.high_x, doctest::Approx(extent.high_x));
  }
}

TEST_CASE("a steep one is not held where it is blocked, and that is told") {
  const parts::Part ramp = parts::ramp(60, 8);
  const core::Settings settings = supported();
  check_depth(supports_of({{ramp, "ModelPart"}}, settings), 1, 21);
  const MarkedBody blocker = marked_block("SupportBlocker", 6, 20);
  check_depth(supports_of({{ramp, "ModelPart"}, blocker}, settings), 1, 6);
  const MarkedBody all = marked_block("SupportBlocker", -5, 40);
  const test::PartFolder folder;
  const Printed none =
      print(settings, folder.add_text("none.3mf", test::prusa_threemf({{ramp, "ModelPart"}, all})));
  CHECK(supports_of(none).empty());
  const Printed held =
      print(settings, folder.add_text("held.3mf", test::prusa_threemf({{ramp, "ModelPart"}})));
  CHECK_GT(told(none), told(held));
  CHECK(supports_of({{ramp, "ModelPart", [](std::int64_t) { return "8"; }}}, settings).empty());
  // An enforcer over it does not bring it back.
  const MarkedBody enforcer = marked_block("SupportEnforcer", 3, 10);
  check_depth(supports_of({{ramp, "ModelPart"}, blocker, enforcer}, settings), 1, 6);
}

TEST_CASE("a shelf's flat underside is held or not, as it is painted") {
  const core::Settings settings = supported();
  core::Settings by_hand = settings;
  by_hand.support_auto = false;
  const parts::Part tee = parts::tee();
  // The deck is the second box; its underside is the first two facets of it.
  const auto painted = [&](const std::string& text) {
    return MarkedBody{tee, "ModelPart", [=](std::int64_t facet) {
                        return facet == 12 || facet == 13 ? text : std::string();
                      }};
  };
  CHECK(supports_of({{tee, "ModelPart"}}, by_hand).empty());
  const Extent automatic = supports_of({{tee, "ModelPart"}}, settings);
  const Extent enforced = supports_of({painted("4")}, by_hand);
  CHECK_EQ(enforced.low_x, doctest::Approx(automatic.low_x));
  CHECK_EQ(enforced.high_x, doctest::Approx(automatic.high_x));
  check_depth(enforced, 1, 11);
  CHECK(supports_of({painted("8")}, settings).empty());
}

TEST_CASE("between heights that are off nothing is held, but what is enforced") {
  core::Settings settings = supported();
  const parts::Part ramp = parts::ramp(60, 8);
  settings.support_height_range = {"0-6 off"};
  const Extent upper = supports_of({{ramp, "ModelPart"}}, settings);
  // It hangs by more than 45° from z = 2 on; at 6 mm it is 6.9 mm out.
  CHECK_GT(upper.low_x, 11 + 4 * std::tan(60 * 3.14159 / 180) - 0.6);
  const Extent all =
      supports_of({{ramp, "ModelPart"}, marked_block("SupportEnforcer", -5, 40)}, settings);
  CHECK_LT(all.low_x, 12.5);
  settings.support_height_range = {"0-100 off"};
  CHECK(supports_of({{ramp, "ModelPart"}}, settings).empty());
}

TEST_CASE("where nothing can be held, the part is not looked through first, and as much is told") {
  core::Settings settings = supported();
  settings.support_auto = false;
  const test::PartFolder folder;
  const MarkedBody tee{parts::tee(), "ModelPart"};
  const MarkedBody blocker = marked_block("SupportBlocker", -5, 40);
  const auto printed = [&](const char* name, const std::vector<MarkedBody>& bodies) {
    Printed one = print(settings, folder.add_text(name, test::prusa_threemf(bodies)));
    CHECK(supports_of(one).empty());
    return one;
  };
  const Printed plain = printed("plain.3mf", {tee});
  CHECK_EQ(plain.statistics.spilled_bytes, 0);
  CHECK_EQ(printed("blocked.3mf", {tee, blocker}).statistics.spilled_bytes, 0);
  // An enforcer that nothing hangs in.
  const MarkedBody beside{parts::box({40, 1, 0}, 2, 2, 2), "SupportEnforcer"};
  const Printed looked = printed("looked.3mf", {tee, beside});
  CHECK_GT(looked.statistics.spilled_bytes, 0);
  CHECK(plain.texts == looked.texts);
  CHECK_GT(told(plain), 0);
  CHECK_EQ(told(plain), told(looked));
}

TEST_CASE("trees stand under what is marked, too") {
  core::Settings settings = supported();
  settings.support_style = core::SupportStyle::kTree;
  const parts::Part tee = parts::tee();
  const MarkedBody half = marked_block("SupportBlocker", 6, 20);
  const Extent blocked = supports_of({{tee, "ModelPart"}, half}, settings);
  REQUIRE_FALSE(blocked.empty());
  // Branches spread by less than this.
  CHECK_LT(blocked.high_y, 7.5);
  settings.support_auto = false;
  CHECK(supports_of({{tee, "ModelPart"}}, settings).empty());
  const Extent enforced =
      supports_of({{tee, "ModelPart"}, marked_block("SupportEnforcer", 6, 20)}, settings);
  CHECK_GT(enforced.low_y, 4.5);
  CHECK_GT(enforced.high_y, 10);
}

TEST_CASE("marks are the same for any number of threads") {
  const test::PartFolder folder;
  const std::string path = folder.add_text(
      "part.3mf", test::prusa_threemf({{parts::sphere(8), "ModelPart",
                                        [](std::int64_t facet) {
                                          return facet % 3 == 0 ? "041" : facet % 3 == 1 ? "8" : "";
                                        }},
                                       marked_block("SupportEnforcer", 3, 6),
                                       marked_block("SupportBlocker", 8, 2.5)}));
  const Printed one = print(supported(), path);
  REQUIRE_EQ(one.error, "");
  CHECK_FALSE(supports_of(one).empty());
  CHECK(one.texts == print(supported(), path, 3).texts);
}
