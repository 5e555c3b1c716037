// What the booleans stand on: many small cases full of coincidences, and few large ones.
#include "core/booleans/overlay.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "core/booleans/boolean.h"
#include "core/limits.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/units.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"
#include "tools/oracles/reference_boolean.h"

using core::Point;
using core::Region;
using core::Ring;
using test::Random;

namespace {

// A bumpy ring with a hole, shrunk by `inset` of its size and turned.
Region bumpy(int points, double radius_mm, double inset, double turn) {
  std::vector<Ring> rings(2);
  for (int k = 0; k < 2; ++k) {
    const double radius = radius_mm * core::kUnitsPerMm * (k == 0 ? 1 - inset : 0.6 + inset);
    for (int i = 0; i < points / 2; ++i) {
      const double angle = (k == 0 ? 4 : -4) * std::acos(0.0) * i / (points / 2.0);
      const double r = radius * (1 + 0.02 * std::sin(40 * angle + turn));
      rings[static_cast<std::size_t>(k)].push_back(
          {static_cast<std::int32_t>(std::lround(r * std::cos(angle))),
           static_cast<std::int32_t>(std::lround(r * std::sin(angle)))});
    }
  }
  return Region::from_clean_rings(rings);
}

// Points anywhere, no nearer to an edge than rounding reaches.
void check_points(const Region& a, const Region& b, Random& random, double size) {
  const Region united = core::unite(a, b), common = core::intersect(a, b);
  const Region rest = core::subtract(a, b), either = core::exclusive_or(a, b);
  for (const Region* region : {&united, &common, &rest, &either}) CHECK(test::is_clean(*region));
  for (int i = 0; i < 100; ++i) {
    const double x = random.between(-size, size), y = random.between(-size, size);
    if (test::distance_to_boundary(a.rings(), x, y) < 1) continue;
    if (test::distance_to_boundary(b.rings(), x, y) < 1) continue;
    const bool in_a = test::winding_number(a.rings(), x, y) == 1;
    const bool in_b = test::winding_number(b.rings(), x, y) == 1;
    CHECK_EQ(test::winding_number(united.rings(), x, y), in_a || in_b ? 1 : 0);
    CHECK_EQ(test::winding_number(common.rings(), x, y), in_a && in_b ? 1 : 0);
    CHECK_EQ(test::winding_number(rest.rings(), x, y), in_a && !in_b ? 1 : 0);
    CHECK_EQ(test::winding_number(either.rings(), x, y), in_a != in_b ? 1 : 0);
  }
}

}  // namespace

TEST_CASE("random polygons over the whole range") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const double size_mm = 2 * core::kCoordinateMax / core::kUnitsPerMm * 0.999;
    const auto rings = [&] {
      return std::vector<Ring>{test::random_ring(random, 12, size_mm),
                               test::random_ring(random, 8, size_mm)};
    };
    const Region a = core::clean(rings(), core::FillRule::kNonZero);
    const Region b = core::clean(rings(), core::FillRule::kNonZero);
    CHECK(test::is_clean(a));
    check_points(a, b, random, core::kCoordinateMax);
  }
}

TEST_CASE("needles and long edges that are nearly parallel") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const int length = seed % 2 == 0 ? 500'000'000 : 2'000;
    const auto needles = [&] {
      std::vector<Ring> rings;
      for (int i = 0; i < 8; ++i) {
        const auto shift = [&] { return random.integer(-6, 6); };
        const Point tip{-length + shift(), -length / 3 + shift()};
        rings.push_back({tip, {length + shift(), length / 3 + shift()}, {length, length / 3 + 7}});
      }
      return core::clean(rings, core::FillRule::kNonZero);
    };
    const Region a = needles(), b = needles();
    CHECK(test::is_clean(a));
    check_points(a, b, random, length);
  }
}

TEST_CASE("consecutive slices") {
  Random random(1);
  const Region slice = bumpy(400, 30, 0, 0);
  for (const double turn : {0.0, 0.05, 1.0}) {
    for (const double inset : {0.0, 0.001, 0.02}) {
      CAPTURE(turn);
      CAPTURE(inset);
      const Region next = bumpy(400, 30, inset, turn);
      check_points(slice, next, random, 330'000);
      const Region ours = core::intersect(slice, next);
      CHECK_LE(test::widest_difference(ours, core::reference::intersect(slice, next)), 2);
    }
  }
}

TEST_CASE("kept memory doesn't change a result") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region a = test::random_region(random, random.integer(20, 300), 20);
    const Region b = test::random_region(random, random.integer(20, 300), 20);
    // A new thread has no memory yet.
    Region common, rest;
    std::thread([&] { common = core::intersect(a, b); }).join();
    std::thread([&] { rest = core::subtract(a, b); }).join();
    CHECK_EQ(core::intersect(a, b), common);
    CHECK_EQ(core::subtract(a, b), rest);
    CHECK_EQ(core::clean(a.rings(), core::FillRule::kPositive), a);
  }
}

TEST_CASE("what lies within needs no cutting to be taken away") {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region outer = test::random_region(random, random.integer(20, 300), 20);
    const Region offset =
        core::offset(outer, core::Length::from_mm(0.2), core::Length::from_mm(0.01));
    const Region inner = core::clean(offset.rings(), core::FillRule::kPositive);
    if (inner.empty()) continue;
    ++compared;
    CHECK_EQ(core::subtract_within(outer, inner), core::subtract(outer, inner));
  }
  CHECK_GE(compared, 20);
  const Region square = test::region_from_text("0:0 5:0 5:5 0:5");
  CHECK_EQ(core::subtract_within(square, Region()), square);
}

TEST_CASE("rings start at their least point and stand in its order, wherever they started") {
  Random random(3);
  const Region a = test::random_region(random, 200, 20), b = test::random_region(random, 200, 20);
  std::vector<Ring> rings = a.rings();
  for (Ring& ring : rings) std::rotate(ring.begin(), ring.begin() + 1, ring.end());
  std::reverse(rings.begin(), rings.end());
  const Region turned = Region::from_clean_rings(rings);
  const Region common = core::intersect(a, b);
  CHECK_EQ(core::intersect(turned, b), common);
  CHECK_EQ(core::clean(rings, core::FillRule::kNonZero), a);
  for (const Ring& ring : common.rings()) {
    CHECK((*std::min_element(ring.begin(), ring.end()) == ring.front()));
  }
  CHECK(std::is_sorted(common.rings().begin(), common.rings().end(), core::ring_before));
}

TEST_CASE("an operand that was not clean spoils no result, and is counted") {
  const std::int64_t before = core::boolean_retries();
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const auto crossing = [&] {
      return Region::from_clean_rings({test::random_ring(random, random.integer(3, 12), 0.1)});
    };
    const Region a = crossing(), b = crossing();
    // Some are noticed and mended; none stops the program.
    (void)core::unite(a, b);
    (void)core::intersect(a, b);
    (void)core::subtract(a, b);
  }
  CHECK_GT(core::boolean_retries(), before);
}
