#include "core/roads/line_fill.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <vector>

#include "core/regions/polyline.h"
#include "tests/support/random_regions.h"
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
          Length::from_mm(inset_mm)};
}

// The rows alone, without the joins between them.
std::vector<Road> rows_of(const std::vector<Road>& roads) {
  std::vector<Road> rows;
  for (const Road& road : roads) {
    REQUIRE_EQ(road.points.size() % 2, 0);
    for (std::size_t i = 0; i < road.points.size(); i += 2) {
      rows.push_back({road.kind, road.width, false, {road.points[i], road.points[i + 1]}});
    }
  }
  return rows;
}

}  // namespace

TEST_CASE("rows lie at the distance asked for, turned by 90 degrees from layer to layer") {
  const Region square = test::region_from_text("0:0 20:0 20:20 0:20");
  for (const LayerIndex layer : {0, 1, 2}) {
    CAPTURE(layer);
    FillArea area = area_of(square, 2, 0);
    area.layer = layer;
    const std::vector<Road> roads = rows_of(LineFill(45).fill(area));
    REQUIRE_GT(roads.size(), 10);
    std::set<std::int64_t> rows;
    const double slope = layer % 2 == 0 ? 1 : -1;
    for (const Road& road : roads) {
      const Point a = road.points[0], b = road.points[1];
      CHECK(static_cast<double>(b.y - a.y) == doctest::Approx(slope * (b.x - a.x)).epsilon(1e-4));
      const double across = (a.y - slope * a.x) / std::sqrt(2.0) / 20'000;
      CHECK(std::abs(across - 0.5 - std::round(across - 0.5)) < 1e-3);
      rows.insert(std::llround(across - 0.5));
    }
    CHECK_EQ(rows.size(), roads.size());
    // Length of rows times their distance is the area, but for the corners' rows.
    CHECK(test::total_length_mm(roads) * 2 == doctest::Approx(400).epsilon(0.02));
  }
}

TEST_CASE("rows and joins stay inside, and as deep as asked, on random regions") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 80, 30);
    if (region.empty()) continue;
    const double inset = random.between(0.05, 0.6);
    CAPTURE(inset);
    FillArea area = area_of(region, random.between(0.4, 2), inset);
    const auto joined = LineFill(30).fill(area);
    CHECK_GT(test::least_depth_mm(region, rows_of(joined)), inset - 0.001);
    CHECK_GT(test::least_depth_mm(region, joined), -1e-4);
    for (const Road& road : joined) CHECK_GE(road.points.size(), 2);
  }
}

TEST_CASE("rows in a convex area make one road, joined at every end") {
  const Region square = test::region_from_text("0:0 20:0 20:20 0:20");
  const FillArea area = area_of(square, 0.4, 0.1);
  const auto joined = LineFill(45).fill(area);
  CHECK_EQ(joined.size(), 1);
  CHECK_GT(rows_of(joined).size(), 60);
}

TEST_CASE("no join leads through a hole or over a notch") {
  const Region region =
      test::region_from_text("0:0 30:0 30:10 16:10 15:1 14:10 0:10, 5:4 5:6 7:6 7:4");
  for (const double angle : {0.0, 45.0, 80.0}) {
    CAPTURE(angle);
    const auto roads = LineFill(angle).fill(area_of(region, 0.4, 0.05));
    CHECK_GT(roads.size(), 1);
    CHECK_GT(test::least_depth_mm(region, roads), 0);
  }
}

TEST_CASE("nothing to fill, and an area thinner than a row's distance") {
  const Region none;
  CHECK(LineFill(45).fill(area_of(none, 1, 0)).empty());
  const Region thin = test::region_from_text("0:0.1 20:0.1 20:0.2 0:0.2");
  CHECK(LineFill(0).fill(area_of(thin, 1, 0)).empty());
}
