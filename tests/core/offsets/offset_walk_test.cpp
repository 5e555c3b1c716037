#include "core/offsets/offset_walk.h"

#include <doctest/doctest.h>

#include <optional>

#include "core/offsets/polygon_offset.h"
#include "tests/support/offset_checks.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Length;
using core::OffsetContours;
using core::Region;
using test::Random;

TEST_CASE("pieces lie at their depth and points are judged rightly, inwards and outwards") {
  int walked = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_region(random, 60, 20);
    const auto diagram = core::make_voronoi_diagram(region.rings(), 0);
    REQUIRE(diagram.has_value());
    for (const double depth_mm : {0.1, 0.7, 3.0, -0.2, -4.0}) {
      CAPTURE(depth_mm);
      const Length depth = Length::from_mm(depth_mm);
      const std::optional<OffsetContours> contours = core::walk_offset(*diagram, depth);
      REQUIRE(contours.has_value());
      CHECK_LE(test::worst_depth_error(region, depth, *contours), 0.75);
      const Region result = core::flatten(*contours, test::kArcTolerance);
      CHECK(test::is_clean(result));
      CHECK_EQ(test::misjudged_points(region, depth, result, random, 150), 0);
      const Region other =
          core::flatten(core::PolygonOffsetter().offset(region, depth), test::kArcTolerance);
      CHECK_LE(test::widest_difference(result, other),
               test::kOffsetRoundingUnits + static_cast<double>(test::kArcTolerance.units()));
      ++walked;
    }
  }
  CHECK_EQ(walked, 200);
}

TEST_CASE("a square's offsets are squares inwards, and have four arcs outwards") {
  const Region square = test::region_from_text("0:0 10:0 10:10 0:10");
  const auto diagram = core::make_voronoi_diagram(square.rings(), 0);
  REQUIRE(diagram.has_value());
  const auto inset = core::walk_offset(*diagram, Length::from_mm(1));
  REQUIRE(inset.has_value());
  CHECK_EQ(core::flatten(*inset, test::kArcTolerance), test::region_from_text("1:1 9:1 9:9 1:9"));
  const auto outset = core::walk_offset(*diagram, Length::from_mm(-1));
  REQUIRE(outset.has_value());
  REQUIRE_EQ(outset->size(), 1);
  int arcs = 0;
  for (const core::OffsetPiece& piece : outset->front()) {
    arcs += piece.kind == core::OffsetPiece::Kind::kArcCounterClockwise ? 1 : 0;
  }
  CHECK_EQ(arcs, 4);
  CHECK(core::walk_offset(*diagram, Length::from_mm(5.1))->empty());
}
