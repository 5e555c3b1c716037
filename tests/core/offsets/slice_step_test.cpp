#include "core/offsets/slice_step.h"

#include <doctest/doctest.h>

#include <vector>

#include "core/offsets/voronoi_mountain.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Length;
using core::Region;
using core::slice_step;
using core::SliceStep;
using test::region_from_text;

namespace {

const Length kFar = Length::from_mm(100);

// Checks at points everywhere that what is deeper in one than its step says is in the other.
int check_step(const Region& below, const Region& above, SliceStep step) {
  core::Box box = below.box();
  box.add(above.box().min);
  box.add(above.box().max);
  int deep = 0;
  const auto check = [&](const Region& from, const Region& to, Length reach, core::Point at) {
    const double depth = test::signed_distance(from, at.x, at.y);
    if (depth <= static_cast<double>(reach.units()) + 1) return;
    ++deep;
    CAPTURE(at.x);
    CAPTURE(at.y);
    REQUIRE(to.contains(at));
  };
  for (std::int32_t x = box.min.x + 3; x < box.max.x; x += (box.max.x - box.min.x) / 37 + 1) {
    for (std::int32_t y = box.min.y + 5; y < box.max.y; y += (box.max.y - box.min.y) / 41 + 1) {
      check(below, above, step.inwards, {x, y});
      check(above, below, step.outwards, {x, y});
    }
  }
  return deep;
}

Region shaken(const Region& region, test::Random& random, int by) {
  std::vector<core::Ring> rings = region.rings();
  for (core::Ring& ring : rings) {
    for (core::Point& point : ring) {
      point.x += random.integer(-by, by);
      point.y += random.integer(-by, by);
    }
  }
  return Region::from_clean_rings(std::move(rings));
}

}  // namespace

TEST_CASE("a square that shrinks moves as far as its corners, and one way only") {
  const Region outer = region_from_text("0:0 10:0 10:10 0:10");
  const Region inner = region_from_text("1:1 9:1 9:9 1:9");
  const Length diagonal = Length::from_units(14'143);
  CHECK_EQ(slice_step(outer, inner, Length(), kFar).inwards, diagonal);
  CHECK_EQ(slice_step(outer, inner, Length(), kFar).outwards, Length());
  CHECK_EQ(slice_step(inner, outer, Length(), kFar).inwards, Length());
  CHECK_EQ(slice_step(inner, outer, Length(), kFar).outwards, diagonal);
  CHECK_EQ(slice_step(outer, inner, kFar, kFar).outwards, diagonal);  // nobody asks which way
  CHECK_EQ(slice_step(outer, inner, Length(), Length::from_mm(1)).inwards, SliceStep::kUnknown);
  CHECK_EQ(slice_step(outer, outer, Length(), kFar).longest(), Length());
}

TEST_CASE("a square that is moved goes both ways; where a ring is missing, nothing is known") {
  const Region square = region_from_text("0:0 10:0 10:10 0:10");
  const Region moved = region_from_text("0.3:0 10.3:0 10.3:10 0.3:10");
  const SliceStep step = slice_step(square, moved, Length(), kFar);
  CHECK_EQ(step.inwards, Length::from_mm(0.3));
  CHECK_EQ(step.outwards, Length::from_mm(0.3));
  const Region holed = region_from_text("0:0 10:0 10:10 0:10, 4:4 4:6 6:6 6:4");
  CHECK_EQ(slice_step(square, holed, Length(), kFar).inwards, SliceStep::kUnknown);
  // A hole that widens takes something away, and gives nothing.
  const Region wider = region_from_text("0:0 10:0 10:10 0:10, 3.9:3.9 3.9:6.1 6.1:6.1 6.1:3.9");
  CHECK_LE(slice_step(holed, wider, Length(), kFar).inwards, Length::from_mm(0.1415));
  CHECK_EQ(slice_step(holed, wider, Length(), kFar).outwards, Length());
}

TEST_CASE("the leash goes once round, not part of the way: a contour doubled back on itself") {
  // A walk that stopped early would find the small square beside part of the large one.
  const Region large = region_from_text("0:0 20:0 20:20 0:20");
  const Region small = region_from_text("0:0 1:0 1:1 0:1");
  CHECK_GE(slice_step(large, small, Length(), kFar).inwards, Length::from_mm(19));
  CHECK_GE(slice_step(small, large, Length(), kFar).outwards, Length::from_mm(19));
}

TEST_CASE("what is deeper than the step stays, on random regions, shaken or offset") {
  int deep = 0, known = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 40, 12);
    Region other;
    if (seed % 3 == 0) {
      other = core::offset(region, Length::from_units(random.integer(-4'000, 4'000)),
                           Length::from_units(25));
    } else if (seed % 3 == 1) {
      other = shaken(region, random, random.integer(1, 3'000));
      if (!test::is_clean(other)) continue;
    } else {
      other = test::random_region(random, 40, 12);
    }
    if (region.empty() || other.empty()) continue;
    const SliceStep step = slice_step(region, other, Length(), kFar);
    if (step.longest() < SliceStep::kUnknown) ++known;
    deep += check_step(region, other, step);
  }
  MESSAGE("known: " << known << " of 150, " << deep << " deep points");
  CHECK_GT(known, 30);
  CHECK_GT(deep, 1000);
}
