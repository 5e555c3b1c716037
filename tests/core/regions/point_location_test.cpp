#include "core/regions/point_location.h"

#include <doctest/doctest.h>

#include "core/regions/segment_grid.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"

using namespace core;

TEST_CASE("a point is located as Region::contains() does, on the boundary either way") {
  int inside = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 20 + static_cast<int>(seed) * 10, 20);
    const PointLocation location(region);
    const SegmentGrid edges(Length::from_mm(1), region);
    for (int i = 0; i < 500; ++i) {
      const Point p{random.integer(-20'000, 220'000), random.integer(-20'000, 220'000)};
      if (edges.any_within(p, Length())) continue;
      REQUIRE_EQ(location.contains(p), region.contains(p));
      inside += region.contains(p) ? 1 : 0;
    }
  }
  CHECK_GT(inside, 1'000);
}

TEST_CASE("level edges, corners in a row, and nothing") {
  CHECK_FALSE(PointLocation(Region()).contains({0, 0}));
  const Region step = test::region_from_text("0:0 3:0 3:1 2:1 2:2 1:2 1:1 0:1");
  const PointLocation location(step);
  CHECK(location.contains({5'000, 5'000}));
  CHECK(location.contains({15'000, 10'000}));
  CHECK(location.contains({15'000, 15'000}));
  CHECK_FALSE(location.contains({5'000, 15'000}));
  CHECK_FALSE(location.contains({25'000, 15'000}));
  CHECK_FALSE(location.contains({-5'000, 5'000}));
}
