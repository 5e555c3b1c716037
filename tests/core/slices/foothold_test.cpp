#include "core/slices/foothold.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>

#include "core/offsets/voronoi_mountain.h"
#include "core/regions/convex_hull.h"
#include "core/units.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"

using core::Foot;
using core::Length;

namespace {

Foot square_foot(double side_mm) {
  return core::foot_of(test::rectangle(0, 0, side_mm, side_mm), side_mm * side_mm);
}

}  // namespace

TEST_CASE("a square foot holds up to where the push's moment is the bed's at its edge") {
  for (const double side_mm : {2.0, 5.0, 10.0, 15.0, 25.0}) {
    CAPTURE(side_mm);
    const Foot foot = square_foot(side_mm);
    // 0.02 MPa times side³ / 6, by 0.0981 N.
    const double holds_mm = 0.02 * side_mm * side_mm * side_mm / 6 / 0.0981;
    const double told_mm = std::max(holds_mm, 5 * side_mm);
    CHECK_FALSE(core::may_come_loose(foot, told_mm * 0.999));
    CHECK(core::may_come_loose(foot, told_mm * 1.001));
  }
  CHECK(core::may_come_loose(square_foot(4), 60));
  CHECK_FALSE(core::may_come_loose(square_foot(20), 200));
}

TEST_CASE("a foot with a brim is the foot offset outwards") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const core::Ring hull = core::convex_hull(test::random_blob(random, 30, 20, 20, 6, 0.4));
    const core::Region region = core::Region::from_clean_rings({hull});
    const Foot brimmed = core::with_brim(core::foot_of(hull, region.area_mm2()), 3);
    const core::Region grown = core::offset(region, Length::from_mm(-3), Length::from_units(20));
    const core::Ring grown_hull = core::convex_hull(grown.rings().front());
    const Foot offset = core::foot_of(grown_hull, grown.area_mm2());
    CHECK_EQ(brimmed.area_mm2, doctest::Approx(offset.area_mm2).epsilon(1e-3));
    CHECK_EQ(brimmed.breadth_mm, doctest::Approx(offset.breadth_mm).epsilon(1e-3));
    CHECK_EQ(brimmed.outline_mm, doctest::Approx(offset.outline_mm).epsilon(1e-3));
  }
}

TEST_CASE("the brim that is advised is the narrowest that holds") {
  for (const double side_mm : {1.0, 2.0, 4.0, 7.0}) {
    for (const double height_mm : {3.0, 20.0, 60.0, 150.0}) {
      CAPTURE(side_mm);
      CAPTURE(height_mm);
      const Foot foot = square_foot(side_mm);
      const std::optional<int> brim_mm = core::brim_that_holds_mm(foot, height_mm);
      REQUIRE(brim_mm);
      CHECK_FALSE(core::may_come_loose(core::with_brim(foot, *brim_mm), height_mm));
      if (*brim_mm > 0) CHECK(core::may_come_loose(core::with_brim(foot, *brim_mm - 1), height_mm));
    }
  }
  CHECK_EQ(core::brim_that_holds_mm(square_foot(4), 19), 0);
  CHECK_FALSE(core::brim_that_holds_mm(square_foot(1), 3'000).has_value());
}

TEST_CASE("what is narrower than a road stands as a road") {
  CHECK_EQ(core::slenderness(square_foot(0.001), 2), doctest::Approx(2 / core::kRoadBreadth_mm));
  CHECK_FALSE(core::may_come_loose(square_foot(0.001), 0.2));
}
