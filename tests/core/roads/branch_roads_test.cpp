// Branches as roads.
#include "core/roads/branch_roads.h"

#include <doctest/doctest.h>

#include "core/regions/polyline.h"

using namespace core;

namespace {

Point at(double x, double y) {
  return {static_cast<std::int32_t>(x * kUnitsPerMm), static_cast<std::int32_t>(y * kUnitsPerMm)};
}

}  // namespace

TEST_CASE("a branch is drawn on into the wall where it meets it, as far as that is thick") {
  Settings settings;
  settings.loose_anchor = Length::from_mm(0.3);
  const Branches branches = {{at(1, 2), at(11, 2), true, false}, {at(5, 1), at(5, 9), true, true}};
  const std::vector<Road> roads = branch_roads(branches, settings);
  REQUIRE_EQ(roads.size(), 2);
  CHECK(roads[0].points == std::vector<Point>{at(0.7, 2), at(11, 2)});
  CHECK(roads[1].points == std::vector<Point>{at(5, 0.7), at(5, 9.3)});
  CHECK(roads[0].kind == RoadKind::kLoose);
  settings.wall_thickness = Length::from_mm(0.325);
  CHECK(branch_roads(branches, settings)[0].points.front() == at(0.9, 2));
  settings.wall_thickness = Length::from_mm(0.1);
  CHECK(branch_roads(branches, settings)[0].points.front() == at(1, 2));
}

TEST_CASE("beads are as wide as roads, and crossing ones are one region") {
  Settings settings;
  const Branches branches = {{at(1, 2), at(11, 2), true, false}, {at(5, 1), at(5, 9), true, true}};
  const Region beads = branch_beads(branches, settings);
  const double width = settings.road_width.mm();
  CHECK_EQ(beads.area_mm2(), doctest::Approx(18 * width - width * width));
  CHECK_EQ(islands(beads).size(), 1);
}
