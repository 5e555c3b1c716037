#include "core/regions/region.h"

#include <doctest/doctest.h>

#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Island;
using core::Point;
using core::Region;
using core::Ring;
using test::region_from_text;

namespace {

// A frame with an island in its hole, the island with a hole of its own.
const char* const kNested =
    "0:0 10:0 10:10 0:10, 1:1 1:9 9:9 9:1, 3:3 7:3 7:7 3:7, 4:4 4:6 6:6 6:4";

}  // namespace

TEST_CASE("area, perimeter and box count holes") {
  const Region region = region_from_text(kNested);
  CHECK_EQ(region.area_mm2(), doctest::Approx(100 - 64 + 16 - 4));
  CHECK_EQ(region.perimeter_mm(), doctest::Approx(40 + 32 + 16 + 8));
  CHECK_EQ(region.point_count(), 16u);
  CHECK_EQ(region.box().min, Point{0, 0});
  CHECK_EQ(region.box().max, Point{100'000, 100'000});
  CHECK(Region().box().empty());
  CHECK(Region().empty());
}

TEST_CASE("a region contains its inside and its boundary") {
  const Region region = region_from_text(kNested);
  CHECK(region.contains({5'000, 5'000}));
  CHECK(region.contains({0, 0}));
  CHECK(region.contains({10'000, 50'000}));
  CHECK_FALSE(region.contains({20'000, 50'000}));
  CHECK(region.contains({35'000, 50'000}));
  CHECK_FALSE(region.contains({50'000, 50'000}));
  CHECK_FALSE(region.contains({-1, 0}));
  CHECK_FALSE(region.contains({100'001, 50'000}));
}

TEST_CASE("contains agrees with the winding number on random regions") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 100, 20);
    for (int i = 0; i < 200; ++i) {
      const Point p{random.integer(-100'000, 100'000), random.integer(-100'000, 100'000)};
      if (test::distance_to_boundary(region.rings(), p.x, p.y) < 1) continue;
      CHECK_EQ(region.contains(p), test::winding_number(region.rings(), p.x, p.y) == 1);
    }
  }
}

TEST_CASE("islands have their own holes, also when they nest") {
  const std::vector<Island> pieces = core::islands(region_from_text(kNested));
  REQUIRE_EQ(pieces.size(), 2u);
  REQUIRE_EQ(pieces[0].holes.size(), 1u);
  REQUIRE_EQ(pieces[1].holes.size(), 1u);
  CHECK_EQ(pieces[0].holes[0][0], Point{10'000, 10'000});
  CHECK_EQ(pieces[1].holes[0][0], Point{40'000, 40'000});
}

TEST_CASE("a hole that touches its island with every corner is still its hole") {
  const std::vector<Island> pieces =
      core::islands(region_from_text("0:0 10:0 10:10 0:10, 5:0 0:5 5:10 10:5"));
  REQUIRE_EQ(pieces.size(), 1u);
  CHECK_EQ(pieces[0].holes.size(), 1u);
}

TEST_CASE("is_clean sees each kind of dirt") {
  const auto clean = [](const char* text) {
    return test::is_clean(Region::from_clean_rings(test::rings_from_text(text)));
  };
  CHECK(clean("0:0 2:0 2:2 0:2"));
  CHECK(clean("0:0 2:0 2:2 0:2, 2:2 4:2 4:4 2:4"));            // touch in a corner
  CHECK(clean("0:0 2:0 2:2 0:2, 2:1 4:0 4:2"));                // touch in an edge
  CHECK_FALSE(clean("0:0 0:2 2:2 2:0"));                       // a hole in nothing
  CHECK_FALSE(clean("0:0 2:0 2:2 0:2, 1:0.5 1.5:0.5 1.5:1"));  // winding number 2
  CHECK_FALSE(clean("0:0 2:2 2:0 0:2"));                       // crosses itself
  CHECK_FALSE(clean("0:0 2:0 2:2 0:2, 2:0 4:0 4:2 2:2"));      // an edge in common
  CHECK_FALSE(clean("0:0 2:0 2:0 2:2 0:2"));                   // repeated neighbour
  CHECK_FALSE(clean("0:0 2:0"));
  CHECK_FALSE(clean("0:0 2:0 4:0"));
}
