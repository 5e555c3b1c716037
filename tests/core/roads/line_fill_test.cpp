#include "core/roads/line_fill.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <vector>

#include "core/roads/row_turn.h"
#include "core/settings.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"
#include "tests/support/road_checks.h"

using namespace core;

namespace {

FillArea area_of(const Region& region, double distance_mm, double inset_mm) {
  return {region,
          0,
          RoadKind::kSolid,
          Length::from_mm(0.45),
          Length::from_mm(distance_mm),
          Length::from_mm(inset_mm),
          Settings().arc_tolerance};
}

}  // namespace

TEST_CASE("rows lie at the distance asked for, turned by 90 degrees from layer to layer") {
  const Region square = test::region_from_text("0:0 20:0 20:20 0:20");
  for (const LayerIndex layer : {0, 1, 2}) {
    CAPTURE(layer);
    FillArea area = area_of(square, 2, 0);
    area.layer = layer;
    const FilledRows filled = LineFill(45).fill(area);
    REQUIRE_GT(filled.stretches.size(), 10);
    REQUIRE_EQ(filled.roads.size(), 1);
    const RowTurn turn(layer % 2 == 0 ? 45 : 135);
    double rows_mm = 0;
    std::set<std::int64_t> rows;
    for (const RowStretch& stretch : filled.stretches) {
      const double across = (static_cast<double>(stretch.row) + 0.5) * 20'000;
      for (const double along : {stretch.from, stretch.to}) {
        const Point end = turn.to_plane(along, across);
        CHECK_LE(test::distance_to_boundary(square.rings(), end.x, end.y), 3);
      }
      rows_mm += (stretch.to - stretch.from) / kUnitsPerMm;
      rows.insert(stretch.row);
    }
    CHECK_EQ(rows.size(), filled.stretches.size());
    // Length of rows times their distance is the area, but for the corners' rows.
    CHECK(rows_mm * 2 == doctest::Approx(400).epsilon(0.02));
    // Every second gap between two rows' ends is laid: about half of the contour.
    CHECK(test::total_length_mm(filled.roads) - rows_mm == doctest::Approx(40).epsilon(0.1));
  }
}

TEST_CASE("rows and joins stay as deep inside as asked, on random regions") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 80, 30);
    if (region.empty()) continue;
    const double inset = random.between(0.05, 0.6);
    CAPTURE(inset);
    const FillArea area = area_of(region, random.between(0.4, 2), inset);
    const FilledRows filled = LineFill(30).fill(area);
    // Chords of the inset's round corners cut them by the arcs' tolerance.
    CHECK_GT(test::least_depth_mm(region, filled.roads), inset - 0.004);
    for (const Road& road : filled.roads) CHECK_GE(road.points.size(), 2);
  }
}

TEST_CASE("rows in a convex area make one road, joined at every end") {
  const Region square = test::region_from_text("0:0 20:0 20:20 0:20");
  const FilledRows filled = LineFill(45).fill(area_of(square, 0.4, 0.1));
  CHECK_EQ(filled.roads.size(), 1);
  CHECK_GT(filled.stretches.size(), 60);
}

TEST_CASE("no join leads through a hole or over a notch") {
  const Region region =
      test::region_from_text("0:0 30:0 30:10 16:10 15:1 14:10 0:10, 5:4 5:6 7:6 7:4");
  for (const double angle : {0.0, 45.0, 80.0}) {
    CAPTURE(angle);
    const FilledRows filled = LineFill(angle).fill(area_of(region, 0.4, 0.05));
    CHECK_GT(filled.roads.size(), 1);
    CHECK_GT(test::least_depth_mm(region, filled.roads), 0.045);
  }
}

TEST_CASE("nothing to fill, and an area thinner than a row's distance") {
  const Region none;
  CHECK(LineFill(45).fill(area_of(none, 1, 0)).roads.empty());
  const Region thin = test::region_from_text("0:0.1 20:0.1 20:0.2 0:0.2");
  CHECK(LineFill(0).fill(area_of(thin, 1, 0)).roads.empty());
}
