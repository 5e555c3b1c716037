#include "core/roads/road_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "core/regions/polyline.h"
#include "core/roads/island_split.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

Road line(RoadKind kind, Point a, Point b) { return {kind, Length::from_mm(0.45), false, {a, b}}; }

std::vector<Road> random_roads(test::Random& random, int count) {
  std::vector<Road> roads;
  for (int i = 0; i < count; ++i) {
    const Point a{random.integer(0, 500'000), random.integer(0, 500'000)};
    const Point b{a.x + random.integer(1, 20'000), a.y + random.integer(1, 20'000)};
    if (i % 3 == 0) {
      const Point c{a.x, b.y};
      roads.push_back({RoadKind::kPerimeter, Length::from_mm(0.45), true, {a, b, c}});
    } else {
      roads.push_back(line(RoadKind::kSolid, a, b));
    }
  }
  return roads;
}

// The same points, whichever way a road runs and wherever it starts.
std::vector<std::vector<Point>> points_of(const std::vector<Road>& roads) {
  std::vector<std::vector<Point>> all;
  for (const Road& road : roads) {
    all.push_back(road.points);
    std::sort(all.back().begin(), all.back().end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<IslandRoads> by_island(const std::vector<Road>& roads, const Region& slice) {
  const IslandSplit split(slice);
  std::vector<IslandRoads> all(split.islands().size());
  for (const Road& road : roads) all[split.island_of(road.points.front())].push_back(road);
  return all;
}

}  // namespace

TEST_CASE("outer perimeters come first where wanted, but for those that overhang") {
  const auto square = [](RoadKind kind, std::int32_t inset) {
    const std::int32_t far = 100'000 - inset;
    return Road{kind,
                Length::from_mm(0.45),
                true,
                {{inset, inset}, {far, inset}, {far, far}, {inset, far}}};
  };
  Road outer = square(RoadKind::kOuterPerimeter, 2'000);
  const Road inner = square(RoadKind::kPerimeter, 6'000);
  const auto first_kind = [&](bool outer_first) {
    return printing_order({{0, 0}, {}, {{inner, outer}}, outer_first}).front().kind;
  };
  CHECK_EQ(first_kind(false), RoadKind::kPerimeter);
  CHECK_EQ(first_kind(true), RoadKind::kOuterPerimeter);
  outer.holds.assign(4, Hold::kWhole);
  outer.holds[2] = Hold::kQuarter;
  CHECK_EQ(first_kind(true), RoadKind::kPerimeter);
}

TEST_CASE("the perimeter of a hole in a bridge comes after the bridge") {
  Road hole{RoadKind::kOuterPerimeter,
            Length::from_mm(0.45),
            true,
            {{0, 0}, {0, 50'000}, {50'000, 50'000}, {50'000, 0}}};
  hole.holds.assign(4, Hold::kLittle);
  const Road bridge{RoadKind::kBridge, Length::from_mm(0.32), false, {{-90'000, 0}, {-3'000, 0}}};
  CHECK_EQ(printing_order({{0, 0}, {}, {{hole, bridge}}}).front().kind, RoadKind::kBridge);
  std::reverse(hole.points.begin(), hole.points.end());  // an outer contour
  CHECK_EQ(printing_order({{0, 0}, {}, {{hole, bridge}}}).front().kind, RoadKind::kOuterPerimeter);
}

TEST_CASE("every road is printed once, each from the nearest end that was left") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const std::vector<Road> roads = random_roads(random, 60);
    Point at{0, 0};
    const std::vector<Road> ordered = nearest_order(roads, at);
    CHECK_EQ(points_of(ordered), points_of(roads));
    Point nozzle{0, 0};
    for (std::size_t i = 0; i < ordered.size(); ++i) {
      const double took = distance_mm(nozzle, ordered[i].points.front());
      for (std::size_t k = i + 1; k < ordered.size(); ++k) {
        CHECK_LE(took, distance_mm(nozzle, ordered[k].points.front()));
        if (ordered[k].closed) continue;
        CHECK_LE(took, distance_mm(nozzle, ordered[k].points.back()));
      }
      nozzle = ordered[i].closed ? ordered[i].points.front() : ordered[i].points.back();
    }
    CHECK_EQ(at, nozzle);
  }
}

TEST_CASE("a closed road begins at a corner, where it has one") {
  // Midpoints of sides are nearer than corners.
  Road ring{
      RoadKind::kOuterPerimeter,
      Length::from_mm(0.45),
      true,
      {{0, 0}, {50'000, 0}, {100'000, 0}, {100'000, 100'000}, {50'000, 100'000}, {0, 100'000}}};
  Point at{52'000, -10'000};
  const auto ordered = nearest_order({ring}, at);
  CHECK_EQ(ordered.front().points.front(), (Point{100'000, 0}));
}

TEST_CASE("a closed road begins at one of its starts, where it has any") {
  Road ring{RoadKind::kOuterPerimeter,
            Length::from_mm(0.45),
            true,
            {{0, 0}, {100'000, 0}, {100'000, 100'000}, {0, 100'000}}};
  ring.starts = {2, 3};
  Point at{90'000, -10'000};
  const auto ordered = nearest_order({ring}, at);
  CHECK_EQ(ordered.front().points.front(), (Point{100'000, 100'000}));
  CHECK_EQ(at, (Point{100'000, 100'000}));
}

TEST_CASE("an island is done before the next; perimeters, outer perimeter, all fill") {
  const Region slice =
      test::region_from_text("0:0 20:0 20:20 0:20, 5:5 5:15 15:15 15:5, 8:8 12:8 12:12 8:12");
  std::vector<Road> roads;
  const auto add = [&](RoadKind kind, double x, double y) {
    const Point a{static_cast<std::int32_t>(x * 10'000), static_cast<std::int32_t>(y * 10'000)};
    roads.push_back(line(kind, a, {a.x + 1'000, a.y}));
  };
  for (const double x : {9.0, 1.0, 10.0, 17.0}) {
    const double y = x == 9 || x == 10 ? 10 : 18;
    add(RoadKind::kLoose, x, y);
    add(RoadKind::kSolid, x, y + 0.1);
    add(RoadKind::kOuterPerimeter, x, y + 0.2);
    add(RoadKind::kGapFill, x, y + 0.3);
    add(RoadKind::kPerimeter, x, y + 0.4);
  }
  const auto ordered = printing_order({{0, 0}, {}, by_island(roads, slice)});
  REQUIRE_EQ(ordered.size(), 20);
  const auto inner = [](const Road& road) {
    return road.points.front().x > 50'000 && road.points.front().x < 150'000;
  };
  const auto stage = [](RoadKind kind) {
    if (kind == RoadKind::kPerimeter) return 0;
    if (kind == RoadKind::kOuterPerimeter) return 1;
    return 2;
  };
  int changes = 0;
  for (std::size_t i = 1; i < ordered.size(); ++i) {
    if (inner(ordered[i - 1]) != inner(ordered[i])) {
      ++changes;
      continue;
    }
    CHECK_LE(stage(ordered[i - 1].kind), stage(ordered[i].kind));
  }
  CHECK_EQ(changes, 1);
}

TEST_CASE("the same roads give the same order") {
  test::Random random(7);
  const std::vector<Road> roads = random_roads(random, 80);
  const Region slice = test::region_from_text("0:0 60:0 60:60 0:60");
  const auto once = printing_order({{0, 0}, {}, by_island(roads, slice)});
  const auto again = printing_order({{0, 0}, {}, by_island(roads, slice)});
  REQUIRE_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) CHECK_EQ(once[i].points, again[i].points);
}

TEST_CASE("tops, bottoms and ironing keep their order and their way round") {
  const Region slice = test::region_from_text("0:0 60:0 60:60 0:60");
  std::vector<Road> roads;
  for (const std::int32_t y : {500, 100, 400, 200, 300}) {
    for (const RoadKind kind : {RoadKind::kIroning, RoadKind::kTopSolid, RoadKind::kBottomSolid}) {
      roads.push_back(line(kind, {y % 200 == 0 ? 0 : 1'000, y * 1'000}, {2'000, y * 1'000}));
    }
    roads.push_back(line(RoadKind::kLoose, {0, y}, {10, y}));
  }
  LayerRoads layer;
  layer.islands = by_island(roads, slice);
  const std::vector<Road> ordered = printing_order(std::move(layer));
  REQUIRE_EQ(ordered.size(), 20);
  std::size_t at = 0;
  for (const RoadKind kind :
       {RoadKind::kBottomSolid, RoadKind::kLoose, RoadKind::kTopSolid, RoadKind::kIroning}) {
    for (const Road& road : roads) {
      if (road.kind != kind) continue;
      CHECK_EQ(ordered[at].kind, kind);
      if (kind != RoadKind::kLoose) CHECK_EQ(ordered[at].points, road.points);
      ++at;
    }
  }
}
