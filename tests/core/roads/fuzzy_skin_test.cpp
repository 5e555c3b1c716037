#include "core/roads/fuzzy_skin.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/regions/polyline.h"
#include "core/regions/region.h"
#include "tests/support/random_regions.h"

using namespace core;

namespace {

Settings rough(FuzzySkin skin) {
  Settings settings;
  settings.fuzzy_skin = skin;
  return settings;
}

Road ring_road(std::uint64_t seed) {
  test::Random random(seed);
  return {RoadKind::kOuterPerimeter, Length::from_mm(0.45), true,
          test::random_blob(random, 60, 30, 30, 15, 0.2)};
}

Road made(const Road& road, LayerIndex layer, const Settings& settings) {
  std::vector<Road> roads = {road};
  make_fuzzy(roads, layer, settings);
  return roads.front();
}

double distance_from(const Road& road, Point at) {
  double least = 1e9;
  for (std::size_t i = 0; i < road.points.size(); ++i) {
    const Point a = road.points[i], b = road.points[(i + 1) % road.points.size()];
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double along = ((at.x - a.x) * dx + (at.y - a.y) * dy) / (dx * dx + dy * dy);
    const double t = std::clamp(along, 0.0, 1.0);
    least = std::min(least, std::hypot(a.x + t * dx - at.x, a.y + t * dy - at.y));
  }
  return least / kUnitsPerMm;
}

}  // namespace

TEST_CASE("points lie within the thickness, on both sides, about the distance apart") {
  const Settings settings = rough(FuzzySkin::kOuter);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    const Road smooth = ring_road(seed);
    const Road road = made(smooth, 5, settings);
    REQUIRE(road.closed);
    double farthest = 0, mean = 0;
    for (const Point at : road.points) {
      const double mm = distance_from(smooth, at);
      CHECK_LE(mm, 0.3 + 2e-4);
      farthest = std::max(farthest, mm);
      mean += mm / static_cast<double>(road.points.size());
    }
    CHECK_GT(farthest, 0.25);
    CHECK(mean == doctest::Approx(0.15).epsilon(0.2));
    const double apart = length_mm(smooth) / static_cast<double>(road.points.size());
    CHECK(apart == doctest::Approx(0.8).epsilon(0.05));
    // In and out alike: the area stays.
    const double before = doubled_area_units(smooth.points),
                 after = doubled_area_units(road.points);
    CHECK(after == doctest::Approx(before).epsilon(0.01));
  }
}

TEST_CASE("the same road is the same in the same layer, and another one in the next") {
  const Settings settings = rough(FuzzySkin::kOuter);
  const Road smooth = ring_road(1);
  CHECK_EQ(made(smooth, 5, settings).points, made(smooth, 5, settings).points);
  CHECK_NE(made(smooth, 5, settings).points, made(smooth, 6, settings).points);
  // Whatever other roads there are.
  std::vector<Road> roads = {ring_road(2), smooth};
  make_fuzzy(roads, 5, settings);
  CHECK_EQ(roads[1].points, made(smooth, 5, settings).points);
}

TEST_CASE("only outer perimeters are rough, holes if asked, never the first layer") {
  const Road outer = ring_road(1);
  Road hole = outer, inner = outer;
  std::reverse(hole.points.begin(), hole.points.end());
  inner.kind = RoadKind::kPerimeter;
  const auto changes = [](const Road& road, LayerIndex layer, FuzzySkin skin) {
    return made(road, layer, rough(skin)).points != road.points;
  };
  CHECK(changes(outer, 1, FuzzySkin::kOuter));
  CHECK_FALSE(changes(hole, 1, FuzzySkin::kOuter));
  CHECK(changes(hole, 1, FuzzySkin::kAll));
  CHECK_FALSE(changes(inner, 1, FuzzySkin::kAll));
  CHECK_FALSE(changes(outer, 0, FuzzySkin::kAll));
  CHECK_FALSE(changes(outer, 1, FuzzySkin::kNone));
}

TEST_CASE("widths and holds go with the points; ends of open roads stay near; crumbs stay") {
  Road road{RoadKind::kOuterPerimeter, Length::from_mm(0.45), false, {{0, 0}, {100'000, 0}}};
  road.widths = {Length::from_mm(0.3), Length::from_mm(0.5)};
  road.holds = {Hold::kHalf, Hold::kWhole};
  const Road made_rough = made(road, 3, rough(FuzzySkin::kOuter));
  const std::size_t count = made_rough.points.size();
  REQUIRE_GT(count, 9);
  REQUIRE_EQ(made_rough.widths.size(), count);
  REQUIRE_EQ(made_rough.holds.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = made_rough.points[i].x / 100'000.0;
    CHECK(made_rough.widths[i].mm() == doctest::Approx(0.3 + 0.2 * share).epsilon(0.001));
    CHECK(made_rough.holds[i] == Hold::kHalf);
  }
  CHECK_EQ(made_rough.points.front().x, 0);
  CHECK_EQ(made_rough.points.back().x, 100'000);
  const Road crumb{
      RoadKind::kOuterPerimeter, Length::from_mm(0.45), true, {{0, 0}, {5'000, 0}, {0, 5'000}}};
  CHECK_EQ(made(crumb, 3, rough(FuzzySkin::kOuter)).points, crumb.points);
}
