#include "core/roads/short_ways.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "core/offsets/slice_offsets.h"
#include "core/regions/polyline.h"
#include "core/roads/road_order.h"
#include "core/roads/road_planner.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"
#include "tests/support/road_checks.h"

using namespace core;

namespace {

constexpr Length kWidth = Length::from_units(4'500);

Road row(std::vector<Point> points, RoadKind kind = RoadKind::kSolid) {
  return {kind, kWidth, false, std::move(points)};
}

Point end_of(const Road& road) { return road.closed ? road.points.front() : road.points.back(); }

bool is_perimeter(const Road& road) {
  return road.kind == RoadKind::kPerimeter || road.kind == RoadKind::kOuterPerimeter;
}

// Travels that are no longer than a short way, between roads of the fill.
int short_travels(const std::vector<Road>& roads) {
  int count = 0;
  for (std::size_t i = 1; i < roads.size(); ++i) {
    if (is_perimeter(roads[i - 1]) || is_perimeter(roads[i])) continue;
    const double mm = distance_mm(end_of(roads[i - 1]), roads[i].points.front());
    if (mm > 0 && mm <= kShortWayMax.mm()) ++count;
  }
  return count;
}

// By orientation of the four corners, away from where they touch.
bool cross_each_other(const Segment& a, const Segment& b) {
  const auto sides = [](const Segment& line, const Segment& of) {
    return (cross(line.from, line.to, of.from) > 0) != (cross(line.from, line.to, of.to) > 0);
  };
  return sides(a, b) && sides(b, a);
}

SplitLayer all_solid(const Region& slice, const Settings& settings) {
  SplitLayer layer;
  layer.slice.index = 4;
  layer.slice.height = settings.layer_height;
  layer.slice.bottom = settings.layer_height * 4;
  layer.slice.region = slice;
  layer.offsets = OffsetCutter(settings).cut(layer.slice);
  layer.solid = slice;
  return layer;
}

const Region kSquare = test::region_from_text("0:0 20:0 20:20 0:20");

}  // namespace

TEST_CASE("the way to a near road is laid, as narrow as a road may be") {
  const Settings settings;
  std::vector<Road> roads = {row({{50'000, 50'000}, {90'000, 50'000}}),
                             row({{95'000, 60'000}, {50'000, 60'000}}),
                             row({{50'000, 80'000}, {90'000, 80'000}})};
  lay_short_ways(kSquare, settings, roads);
  REQUIRE_EQ(roads.size(), 4);
  CHECK_EQ(roads[1].points, std::vector<Point>{{90'000, 50'000}, {95'000, 60'000}});
  CHECK_EQ(roads[1].width, settings.road_width_min);
  CHECK_EQ(roads[1].kind, RoadKind::kGapFill);
}

TEST_CASE("no way across a perimeter, near the contour, to or from what is no fill") {
  const Settings settings;
  const Road from = row({{50'000, 50'000}, {90'000, 50'000}});
  const Road to = row({{90'000, 60'000}, {50'000, 60'000}});
  const auto count = [&](const std::vector<Road>& given, const Region& slice) {
    std::vector<Road> roads = given;
    lay_short_ways(slice, settings, roads);
    return roads.size() - given.size();
  };
  CHECK_EQ(count({from, to}, kSquare), 1);
  const Road between = row({{40'000, 55'000}, {100'000, 55'000}}, RoadKind::kPerimeter);
  CHECK_EQ(count({between, from, to}, kSquare), 0);
  // A slit's end comes within half a narrow road of the way, or doesn't.
  CHECK_EQ(
      count({from, to}, test::region_from_text("0:0 20:0 20:5.45 9.09:5.5 20:5.55 20:20 0:20")), 0);
  CHECK_EQ(
      count({from, to}, test::region_from_text("0:0 20:0 20:5.45 9.11:5.5 20:5.55 20:20 0:20")), 1);
  for (const RoadKind kind : {RoadKind::kTopSolid, RoadKind::kBridge, RoadKind::kPerimeter,
                              RoadKind::kOuterPerimeter, RoadKind::kSkirt, RoadKind::kIroning}) {
    CAPTURE(static_cast<int>(kind));
    CHECK_EQ(count({row(from.points, kind), to}, kSquare), 0);
    CHECK_EQ(count({from, row(to.points, kind)}, kSquare), 0);
  }
  Road thick = row(to.points, RoadKind::kLoose);
  CHECK_EQ(count({from, thick}, kSquare), 1);
  thick.layers = 2;
  CHECK_EQ(count({from, thick}, kSquare), 0);
}

TEST_CASE("a ring of the fill ends where its seam's gap begins, and the way begins there") {
  const Settings settings;
  Road ring = row({{50'000, 50'000}, {90'000, 50'000}, {90'000, 90'000}});
  ring.closed = true;
  std::vector<Road> roads = {ring, row({{45'000, 45'000}, {45'000, 90'000}})};
  lay_short_ways(kSquare, settings, roads);
  REQUIRE_EQ(roads.size(), 3);
  CHECK_FALSE(roads[0].closed);
  CHECK_EQ(roads[0].points, opened(ring, settings.seam_gap).points);
  CHECK_EQ(roads[1].points.front(), roads[0].points.back());
  CHECK_EQ(roads[1].points.back(), roads[2].points.front());
}

TEST_CASE("random layers: fewer travels, and no way leaves the slice or crosses a perimeter") {
  const Settings settings;
  int before = 0, after = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region slice = test::random_region(random, 60, 25);
    const std::vector<Road> ordered =
        printing_order(RoadPlanner(settings).plan(all_solid(slice, settings)));
    std::vector<Road> roads = ordered;
    lay_short_ways(slice, settings, roads);
    before += short_travels(ordered);
    after += short_travels(roads);
    std::vector<Road> ways;
    std::size_t next = 0;
    for (const Road& road : roads) {
      const bool kept = next < ordered.size() && road.kind == ordered[next].kind &&
                        road.points.front() == ordered[next].points.front() &&
                        road.width == ordered[next].width;
      if (kept) {
        ++next;
      } else {
        ways.push_back(road);
      }
    }
    CHECK_EQ(next, ordered.size());
    CHECK_LE(test::sticks_out_mm(slice, ways), 1e-3);
    for (const Road& road : ordered) {
      if (!is_perimeter(road)) continue;
      for (std::size_t i = 0; i < road.points.size(); ++i) {
        const Segment edge{road.points[i], road.points[(i + 1) % road.points.size()]};
        for (const Road& way : ways) {
          CHECK_FALSE(cross_each_other(edge, {way.points[0], way.points[1]}));
        }
      }
    }
  }
  CHECK_LT(after, before * 3 / 4);
}
