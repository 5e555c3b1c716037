#include "core/supports/airborne_stretches.h"

#include <doctest/doctest.h>

#include "core/booleans/boolean.h"
#include "core/regions/polyline.h"
#include "tests/support/region_text.h"

using namespace core;
using test::rectangle;
using test::rectangle_region;

TEST_CASE("a straight stretch between two held places holds, a bent or a long one does not") {
  const Settings settings;
  const Region sides = unite(rectangle_region(0, 0, 4, 30), rectangle_region(12, 0, 4, 30));
  const PointLocation below(sides);
  CHECK(airborne_stretches(rectangle(1, 1, 15, 20), below, settings).empty());
  Settings short_bridges;
  short_bridges.bridge_max = Length::from_mm(7);
  CHECK_EQ(airborne_stretches(rectangle(1, 1, 15, 20), below, short_bridges).size(), 2);
  const auto bent = airborne_stretches(rectangle(1, 1, 8, 20), below, settings);
  REQUIRE_EQ(bent.size(), 1);
  CHECK_EQ(length_mm(bent.front(), false), doctest::Approx(4 + 19 + 4).epsilon(0.03));
  // All around, in the air.
  CHECK_EQ(airborne_stretches(rectangle(5, 5, 11, 11), below, settings).size(), 1);
  // A bend of less than a road.
  CHECK(airborne_stretches(rectangle(1, 1, 4.2, 20),
                           PointLocation(rectangle_region(0, 0, 4.1, 19.9)), settings)
            .size() <= 1);
}

TEST_CASE("strips cover all within reach of the lines, and not much more") {
  std::vector<Ring> strips;
  std::vector<Point> line;
  for (int x = 0; x <= 50'000; x += 2'000) line.push_back({x, 0});
  add_strips({line}, Length::from_mm(0.5), strips);
  const Region region = clean(strips, FillRule::kPositive);
  CHECK(region.contains({25'000, 4'900}));
  CHECK(region.contains({51'000, 4'000}));
  CHECK_FALSE(region.contains({25'000, 5'100}));
  CHECK_FALSE(region.contains({56'000, 0}));
}
