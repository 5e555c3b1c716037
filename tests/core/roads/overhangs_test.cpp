#include "core/roads/overhangs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/regions/polyline.h"
#include "core/vector.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

constexpr double kMm = kUnitsPerMm;

std::vector<Road> outer_roads(const Region& slice, const Settings& settings) {
  std::vector<Road> roads;
  const Length half = Length::from_mm(settings.road_width.mm() / 2);
  const Region line = offset(slice, half, settings.arc_tolerance);
  for (const Ring& ring : line.rings()) {
    roads.push_back({RoadKind::kOuterPerimeter, settings.road_width, true, ring});
  }
  return roads;
}

double held_mm(const Road& road, Hold hold) {
  double sum = 0;
  for (std::size_t i = 0; i < road.points.size(); ++i) {
    if (hold_from(road, i) != hold) continue;
    sum += distance_mm(road.points[i], road.points[(i + 1) % road.points.size()]);
  }
  return sum;
}

// By literal sampling: which share of the bead's width lies over what is below.
double share_at(const Region& below, Point a, Point b, double t, double width) {
  const Vector along = to_vector(b) - to_vector(a);
  const Vector across = left_of(along) * (1 / std::sqrt(dot(along, along)));
  const Vector middle = to_vector(a) + along * t;
  constexpr int kSamples = 40;
  int over = 0;
  for (int i = 0; i < kSamples; ++i) {
    const Vector p = middle + across * (((i + 0.5) / kSamples - 0.5) * width);
    over += test::winding_number(below.rings(), p.x, p.y);
  }
  return static_cast<double>(over) / kSamples;
}

}  // namespace

TEST_CASE("the share of a road that is held gives its hold") {
  CHECK_EQ(hold_of(1), Hold::kWhole);
  CHECK_EQ(hold_of(0.8), Hold::kThreeQuarters);
  CHECK_EQ(hold_of(0.6), Hold::kHalf);
  CHECK_EQ(hold_of(0.4), Hold::kQuarter);
  CHECK_EQ(hold_of(0.1), Hold::kLittle);
}

TEST_CASE("a square that is wider on one side overhangs there, by how far it is wider") {
  Settings settings;
  for (const auto& one : {std::pair{0.0, Hold::kWhole}, std::pair{0.09, Hold::kThreeQuarters},
                          std::pair{0.18, Hold::kHalf}, std::pair{0.3, Hold::kQuarter},
                          std::pair{0.4, Hold::kLittle}, std::pair{3.0, Hold::kLittle}}) {
    const double step = one.first;
    const Hold hold = one.second;
    CAPTURE(step);
    const Region slice = test::rectangle_region(0, 0, 20 + step, 20),
                 below = test::rectangle_region(0, 0, 20, 20);
    std::vector<Road> roads = outer_roads(slice, settings);
    mark_holds(slice, below, settings, roads);
    REQUIRE_EQ(roads.size(), 1);
    if (hold == Hold::kWhole) {
      CHECK(roads.front().holds.empty());
      continue;
    }
    REQUIRE_EQ(roads.front().holds.size(), roads.front().points.size());
    CHECK_GE(held_mm(roads.front(), hold), 19);
    CHECK_LE(held_mm(roads.front(), hold), 20 + 2 * step);
    CHECK_FALSE(in_air(roads.front()));
  }
}

TEST_CASE("a contour over nothing is in the air all along, and keeps its points") {
  Settings settings;
  const Region slice = test::rectangle_region(30, 0, 10, 10);
  std::vector<Road> roads = outer_roads(slice, settings);
  const std::vector<Point> points = roads.front().points;
  mark_holds(slice, test::rectangle_region(0, 0, 10, 10), settings, roads);
  CHECK(in_air(roads.front()));
  CHECK_EQ(roads.front().points, points);
}

TEST_CASE("random parts: marked roads keep their way, and their holds are right by sampling") {
  Settings settings;
  const double width = settings.road_width.mm() * kMm;
  int checked = 0, right = 0;
  for (const unsigned seed : {41U, 42U, 43U, 44U, 45U, 46U}) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region slice = test::random_region(random, 150, 30);
    const Region below =
        offset(slice, Length::from_mm(random.between(-0.5, 0.5)), settings.arc_tolerance);
    const std::vector<Road> plain = outer_roads(slice, settings);
    std::vector<Road> roads = plain;
    mark_holds(slice, below, settings, roads);
    for (std::size_t r = 0; r < roads.size(); ++r) {
      const Road& road = roads[r];
      CHECK_EQ(length_mm(road), doctest::Approx(length_mm(plain[r])).epsilon(1e-4));
      if (road.holds.empty()) continue;
      CHECK_EQ(road.holds.size(), road.points.size());
      for (std::size_t i = 0; i < road.points.size(); ++i) {
        const Point a = road.points[i], b = road.points[(i + 1) % road.points.size()];
        if (distance_mm(a, b) < 0.3) continue;
        const double share = share_at(below, a, b, random.between(0.2, 0.8), width);
        const int off =
            std::abs(static_cast<int>(hold_of(share)) - static_cast<int>(road.holds[i]));
        ++checked;
        right += off <= 1 ? 1 : 0;
      }
    }
  }
  MESSAGE(checked << " stretches, " << right << " right to a step");
  CHECK_GE(checked, 200);
  CHECK_GE(right, checked * 0.95);
}

TEST_CASE("turned round, or started elsewhere, a road's stretches keep their holds") {
  Road road{RoadKind::kOuterPerimeter,
            Length::from_mm(0.45),
            true,
            {{0, 0}, {100, 0}, {100, 100}, {0, 100}}};
  road.holds = {Hold::kWhole, Hold::kHalf, Hold::kQuarter, Hold::kLittle};
  const auto hold_between = [](const Road& r, Point a, Point b) {
    for (std::size_t i = 0; i < r.points.size(); ++i) {
      const Point p = r.points[i], q = r.points[(i + 1) % r.points.size()];
      if ((p == a && q == b) || (p == b && q == a)) return r.holds[i];
    }
    return Hold::kWhole;
  };
  const Road before = road;
  for (int turn = 0; turn < 3; ++turn) {
    if (turn != 1) reverse(road);
    if (turn != 0) start_at(road, 2);
    for (std::size_t i = 0; i < 4; ++i) {
      const Point a = before.points[i], b = before.points[(i + 1) % 4];
      CHECK_EQ(hold_between(road, a, b), before.holds[i]);
    }
  }
  Road open = before;
  open.closed = false;
  reverse(open);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK_EQ(hold_between(open, before.points[i], before.points[i + 1]), before.holds[i]);
  }
}
