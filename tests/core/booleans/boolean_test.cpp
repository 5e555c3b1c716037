#include "core/booleans/boolean.h"

#include <doctest/doctest.h>

#include <functional>

#include "core/limits.h"
#include "core/regions/contact_check.h"
#include "core/units.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::FillRule;
using core::Region;
using core::Ring;
using test::Random;
using test::region_from_text;

namespace {

// Crossing points are rounded, so nearer to an edge than this nothing is said.
constexpr double kRounding = 2;

void check_fill(const std::vector<Ring>& rings, FillRule rule, Random& random, double size_units) {
  const Region region = core::clean(rings, rule);
  CHECK(test::is_clean(region));
  for (int i = 0; i < 400; ++i) {
    const double x = random.between(-size_units, size_units) / 2;
    const double y = random.between(-size_units, size_units) / 2;
    if (test::distance_to_boundary(rings, x, y) < kRounding) continue;
    const int winding = test::winding_number(rings, x, y);
    const bool filled = rule == FillRule::kNonZero ? winding != 0 : winding > 0;
    CHECK_EQ(test::winding_number(region.rings(), x, y), filled ? 1 : 0);
  }
}

}  // namespace

TEST_CASE("clean follows the winding number of random rings") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    // The small ones are all rounding: a few hundred units across.
    const double size_mm = seed % 3 == 0 ? 0.03 : 20;
    std::vector<Ring> rings;
    const int count = random.integer(1, 4);
    for (int i = 0; i < count; ++i) {
      rings.push_back(test::random_ring(random, random.integer(3, 25), size_mm));
    }
    check_fill(rings, FillRule::kNonZero, random, size_mm * core::kUnitsPerMm);
    check_fill(rings, FillRule::kPositive, random, size_mm * core::kUnitsPerMm);
  }
}

TEST_CASE("rings that turn the other way count as non-zero, not as positive") {
  const std::vector<Ring> rings = test::rings_from_text("0:0 0:2 2:2 2:0, 5:0 7:0 7:2 5:2");
  CHECK_EQ(core::clean(rings, FillRule::kNonZero).area_mm2(), doctest::Approx(8));
  CHECK_EQ(core::clean(rings, FillRule::kPositive).area_mm2(), doctest::Approx(4));
}

TEST_CASE("what has no area goes") {
  CHECK(core::clean({}, FillRule::kNonZero).empty());
  CHECK(
      core::clean(test::rings_from_text("0:0, 1:1 2:2, 0:0 5:0 2:0"), FillRule::kNonZero).empty());
  const Region spiked =
      core::clean(test::rings_from_text("0:0 2:0 2:1 9:1 2:1 2:2 0:2"), FillRule::kNonZero);
  CHECK(test::is_clean(spiked));
  CHECK_EQ(spiked.area_mm2(), doctest::Approx(4));
  CHECK_EQ(spiked.perimeter_mm(), doctest::Approx(8));
}

TEST_CASE("touching contours stay") {
  const std::vector<Ring> rings =
      test::rings_from_text("0:0 4:0 4:4 0:4, 4:4 6:4 6:6 4:6, 2:0 1:1 2:2 3:1");
  const Region region = core::clean(rings, FillRule::kNonZero);
  CHECK(test::is_clean(region));
  CHECK_EQ(region.area_mm2(), doctest::Approx(16 + 4 - 2));
}

TEST_CASE("operations on squares have the areas that they should") {
  const Region a = region_from_text("0:0 4:0 4:4 0:4");
  const Region b = region_from_text("2:2 6:2 6:6 2:6");
  CHECK_EQ(core::unite(a, b).area_mm2(), doctest::Approx(28));
  CHECK_EQ(core::intersect(a, b).area_mm2(), doctest::Approx(4));
  CHECK_EQ(core::subtract(a, b).area_mm2(), doctest::Approx(12));
  CHECK_EQ(core::exclusive_or(a, b).area_mm2(), doctest::Approx(24));
}

TEST_CASE("no points are left on straight runs") {
  const Region a = region_from_text("0:0 4:0 4:4 0:4");
  CHECK_EQ(core::unite(a, region_from_text("4:0 8:0 8:4 4:4")).point_count(), 4u);
  CHECK_EQ(core::unite(a, region_from_text("4:1 8:1 8:3 4:3")).point_count(), 8u);
  CHECK_EQ(core::intersect(a, region_from_text("1:1 3:1 3:3 1:3")).point_count(), 4u);
}

TEST_CASE("a square cut from the middle leaves a hole") {
  const Region ring =
      core::subtract(region_from_text("0:0 4:0 4:4 0:4"), region_from_text("1:1 3:1 3:3 1:3"));
  CHECK_EQ(ring.rings().size(), 2u);
  CHECK(test::is_clean(ring));
  CHECK_EQ(core::islands(ring).at(0).holes.size(), 1u);
}

TEST_CASE("short cuts for empty, equal and far operands give what the long way gives") {
  const Region a = region_from_text("0:0 4:0 4:4 0:4");
  const Region far = region_from_text("9:0 10:0 10:4 9:4");
  const Region next = region_from_text("4:0 8:0 8:4 4:4");
  const Region none;
  CHECK_EQ(core::unite(a, none), a);
  CHECK_EQ(core::unite(none, a), a);
  CHECK_EQ(core::unite(a, a), a);
  CHECK_EQ(core::unite(a, far).area_mm2(), doctest::Approx(20));
  CHECK_EQ(core::unite(a, next).rings().size(), 1u);  // no seam
  CHECK(core::intersect(a, none).empty());
  CHECK(core::intersect(none, a).empty());
  CHECK(core::intersect(a, far).empty());
  CHECK(core::intersect(a, next).empty());
  CHECK_EQ(core::intersect(a, a), a);
  CHECK(core::subtract(none, a).empty());
  CHECK(core::subtract(a, a).empty());
  CHECK_EQ(core::subtract(a, none), a);
  CHECK_EQ(core::subtract(a, far), a);
  CHECK(core::exclusive_or(a, a).empty());
  CHECK_EQ(core::exclusive_or(a, none), a);
  CHECK_EQ(core::exclusive_or(none, a), a);
  CHECK_EQ(core::exclusive_or(a, far).area_mm2(), doctest::Approx(20));
}

TEST_CASE("coordinates go up to the limit") {
  const std::int32_t max = core::kCoordinateMax;
  const Region all =
      Region::from_clean_rings({{{-max, -max}, {max, -max}, {max, max}, {-max, max}}});
  const Region half = Region::from_clean_rings({{{0, -max}, {max, -max}, {max, max}, {0, max}}});
  CHECK_EQ(core::intersect(all, half).area_mm2(), doctest::Approx(half.area_mm2()));
  CHECK_EQ(core::subtract(all, half).area_mm2(), doctest::Approx(half.area_mm2()));
}

TEST_CASE("operations agree with winding numbers and laws on random regions") {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region a = test::random_region(random, 120, 20);
    const Region b = test::random_region(random, 120, 20);
    const Region united = core::unite(a, b), common = core::intersect(a, b);
    const Region rest = core::subtract(a, b), either = core::exclusive_or(a, b);
    for (const Region* region : {&a, &b, &united, &common, &rest, &either}) {
      CHECK(test::is_clean(*region));
    }
    CHECK_LE(test::widest_difference(core::unite(rest, common), a), 2);
    CHECK_LE(test::widest_difference(core::subtract(united, common), either), 2);
    CHECK_LE(test::widest_difference(core::intersect(b, a), common), 2);
    for (int i = 0; i < 300; ++i) {
      const double x = random.between(-100'000, 100'000), y = random.between(-100'000, 100'000);
      if (test::distance_to_boundary(a.rings(), x, y) < kRounding ||
          test::distance_to_boundary(b.rings(), x, y) < kRounding) {
        continue;
      }
      const bool in_a = test::winding_number(a.rings(), x, y) == 1;
      const bool in_b = test::winding_number(b.rings(), x, y) == 1;
      CHECK_EQ(test::winding_number(united.rings(), x, y), in_a || in_b ? 1 : 0);
      CHECK_EQ(test::winding_number(common.rings(), x, y), in_a && in_b ? 1 : 0);
      CHECK_EQ(test::winding_number(rest.rings(), x, y), in_a && !in_b ? 1 : 0);
      CHECK_EQ(test::winding_number(either.rings(), x, y), in_a != in_b ? 1 : 0);
    }
  }
}

TEST_CASE("surely_clean never says yes to dirt, and yes to what doesn't touch") {
  int yes = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<Ring> rings;
    const int count = random.integer(1, 3);
    for (int i = 0; i < count; ++i) {
      Ring ring = test::random_ring(random, random.integer(3, 5), seed % 2 == 0 ? 0.002 : 5);
      if (random.integer(0, 1) == 0) std::reverse(ring.begin(), ring.end());
      rings.push_back(ring);
    }
    const bool answer = core::surely_clean(rings);
    if (answer) CHECK(test::is_clean(Region::from_clean_rings(rings)));
    yes += answer ? 1 : 0;
  }
  CHECK_GT(yes, 10);
  Random random(7);
  CHECK(core::surely_clean({test::random_blob(random, 3000, 0, 0, 30, 0.01)}));
  CHECK(core::surely_clean(test::rings_from_text("0:0 9:0 9:9 0:9, 1:1 1:8 8:8 8:1, 2:2 3:2 3:3")));
  CHECK_FALSE(core::surely_clean(test::rings_from_text("0:0 9:0 9:9 0:9, 2:2 3:2 3:3")));
}
