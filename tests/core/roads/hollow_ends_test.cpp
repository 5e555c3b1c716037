// Gap fill over a hollow inside: ends that hang in the air are cut off.
#include "core/roads/hollow_ends.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/regions/polyline.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

Point at(double x, double y) {
  return {static_cast<std::int32_t>(x * kUnitsPerMm), static_cast<std::int32_t>(y * kUnitsPerMm)};
}

// The inside of the layer below: 10 to 20 mm both ways.
SplitLayer over_square() {
  SplitLayer layer;
  layer.below_loose = std::make_shared<const Region>(test::rectangle_region(10, 10, 10, 10));
  return layer;
}

Settings hollow() {
  Settings settings;
  settings.loose_density = 0;
  return settings;
}

Road gap(std::vector<Point> points, bool closed = false) {
  Road road;
  road.kind = RoadKind::kGapFill;
  road.width = Length::from_mm(0.3);
  road.closed = closed;
  road.points = std::move(points);
  return road;
}

std::vector<Road> cut(std::vector<Road> roads, const Settings& settings = hollow()) {
  HollowEnds(over_square(), settings).cut(roads);
  return roads;
}

}  // namespace

TEST_CASE("an end in the air is cut off, with its share of the width") {
  Road road = gap({at(6, 15), at(14, 15)});
  road.widths = {Length::from_mm(0.2), Length::from_mm(0.6)};
  const std::vector<Road> left = cut({road});
  REQUIRE_EQ(left.size(), 1);
  CHECK_EQ(left[0].points.size(), left[0].widths.size());
  double least = 20, most = 0;
  for (const Point p : left[0].points) {
    least = std::min(least, p.x / kUnitsPerMm);
    most = std::max(most, p.x / kUnitsPerMm);
  }
  CHECK_EQ(least, doctest::Approx(6).epsilon(0.001));
  CHECK_EQ(most, doctest::Approx(10).epsilon(0.02));
  const auto [narrow, wide] = std::minmax_element(left[0].widths.begin(), left[0].widths.end());
  CHECK_EQ(narrow->mm(), doctest::Approx(0.2));
  CHECK_EQ(wide->mm(), doctest::Approx(0.4).epsilon(0.03));
}

TEST_CASE("what is held at both ends, what is short, and other kinds stay as they are") {
  const std::vector<Road> kept = {gap({at(6, 15), at(24, 15)}), gap({at(6, 12), at(10.5, 12)})};
  const std::vector<Road> left = cut(kept);
  REQUIRE_EQ(left.size(), 2);
  for (std::size_t i = 0; i < 2; ++i) CHECK(left[i].points == kept[i].points);
  Road solid = gap({at(12, 12), at(14, 14)});
  solid.kind = RoadKind::kSolid;
  CHECK_EQ(cut({solid}).size(), 1);
  Settings filled;
  CHECK_EQ(cut({gap({at(12, 12), at(14, 14)})}, filled).size(), 1);
}

TEST_CASE("what lies in the air all along is left out, open or closed") {
  CHECK(cut({gap({at(12, 12), at(14, 14)})}).empty());
  CHECK(cut({gap({at(12, 12), at(18, 12), at(15, 17)}, true)}).empty());
}

TEST_CASE("a closed road that is in the air in part is opened there") {
  const std::vector<Road> left = cut({gap({at(6, 15), at(14, 12), at(14, 18)}, true)});
  REQUIRE_EQ(left.size(), 1);
  CHECK_FALSE(left[0].closed);
  for (const Point p : left[0].points) CHECK_LE(p.x, 101'500);
  CHECK_GT(length_mm(left[0].points, false), 8);
}
