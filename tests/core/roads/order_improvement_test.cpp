#include "core/roads/order_improvement.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/regions/polyline.h"
#include "core/roads/road_order.h"
#include "tests/support/random_regions.h"

using namespace core;

namespace {

std::vector<Road> random_roads(test::Random& random, int count) {
  std::vector<Road> roads;
  for (int i = 0; i < count; ++i) {
    const Point a{random.integer(0, 500'000), random.integer(0, 500'000)};
    const Point b{a.x + random.integer(1, 50'000), a.y + random.integer(1, 50'000)};
    roads.push_back({RoadKind::kSolid, Length::from_units(4'500 + i), i % 4 == 0, {a, b}});
    if (roads.back().closed) roads.back().points.push_back({a.x, b.y});
  }
  return roads;
}

// By trying every order and every way round.
double least_travel_mm(const std::vector<Road>& roads, Point from) {
  std::vector<std::size_t> order(roads.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  double least = 1e9;
  do {
    for (unsigned turned = 0; turned < 1U << roads.size(); ++turned) {
      std::vector<Road> tried;
      for (const std::size_t i : order) {
        tried.push_back(roads[i]);
        if ((turned >> i & 1U) != 0 && !roads[i].closed) reverse(tried.back());
      }
      least = std::min(least, travel_mm(tried, from));
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

}  // namespace

TEST_CASE("the same roads, closed ones as they were, and no more travel than before") {
  double before_mm = 0, after_mm = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    Point at{0, 0};
    const std::vector<Road> nearest = nearest_order(random_roads(random, 250), at);
    std::vector<Road> improved = nearest;
    improve_order(improved, {0, 0});
    before_mm += travel_mm(nearest, {0, 0});
    after_mm += travel_mm(improved, {0, 0});
    CHECK_LE(travel_cost_mm(improved, {0, 0}), travel_cost_mm(nearest, {0, 0}));
    CHECK_LE(travel_mm(improved, {0, 0}), travel_mm(nearest, {0, 0}));
    std::vector<bool> seen(nearest.size(), false);
    for (const Road& road : improved) {
      const auto number = static_cast<std::size_t>(road.width.units() - 4'500);
      CHECK_FALSE(seen[number]);
      seen[number] = true;
      const auto same = std::find_if(nearest.begin(), nearest.end(),
                                     [&](const Road& r) { return r.width == road.width; });
      std::vector<Point> turned(same->points.rbegin(), same->points.rend());
      const bool as_it_was = road.points == same->points || (!road.closed && road.points == turned);
      CHECK(as_it_was);
    }
    CHECK_EQ(std::count(seen.begin(), seen.end(), true), 250);
  }
  CHECK_LT(after_mm, 0.9 * before_mm);
}

TEST_CASE("a few roads: hardly more than the least travel there is") {
  double least_mm = 0, improved_mm = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    Point at{0, 0};
    std::vector<Road> roads = nearest_order(random_roads(random, 5), at);
    least_mm += least_travel_mm(roads, {0, 0});
    improve_order(roads, {0, 0});
    improved_mm += travel_mm(roads, {0, 0});
  }
  CHECK_LE(improved_mm, 1.03 * least_mm);
}

TEST_CASE("none, one, and roads that touch") {
  std::vector<Road> roads;
  improve_order(roads, {0, 0});
  CHECK(roads.empty());
  roads = {{RoadKind::kSolid, Length::from_mm(0.45), false, {{10, 0}, {0, 0}}}};
  improve_order(roads, {0, 0});
  CHECK_EQ(roads.size(), 1);
  const Road road{RoadKind::kSolid, Length::from_mm(0.45), false, {{0, 0}, {100, 0}}};
  roads = {road, road, road};
  improve_order(roads, {0, 0});
  CHECK_EQ(travel_mm(roads, {0, 0}), 0);
}

TEST_CASE("what is longer than a short way costs a stop, too") {
  const auto road = [](Point from, Point to) {
    return Road{RoadKind::kSolid, Length::from_mm(0.45), false, {from, to}};
  };
  const std::vector<Road> roads = {road({0, 0}, {100'000, 0}), road({100'000, 16'000}, {0, 16'000}),
                                   road({0, 30'000}, {100'000, 30'000})};
  CHECK_EQ(travel_cost_mm(roads, {0, 0}), doctest::Approx(1.6 + kStopMm + 1.4));
  CHECK_EQ(travel_mm(roads, {0, 0}), doctest::Approx(3));
  // 2.9 mm in one go, or 1.4 mm and 1.6 mm: one stop either way, but for a turn that spares it.
  std::vector<Road> turned = {road({0, 0}, {100'000, 0}), road({0, 10'000}, {100'000, 14'000})};
  improve_order(turned, {0, 0});
  CHECK_EQ(travel_cost_mm(turned, {0, 0}), doctest::Approx(1.4));
}
