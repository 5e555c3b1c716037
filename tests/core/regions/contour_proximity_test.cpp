#include "core/regions/contour_proximity.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/offsets/polygon_offset.h"
#include "core/regions/polyline.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::frechet_within;
using core::Length;
using core::Point;
using core::Region;
using test::Random;
using test::region_from_text;

namespace {

// The farthest that a point of a's contours, looked at every 20 µm, is from b's contours. Units.
double farthest_units(const Region& a, const Region& b) {
  double farthest = 0;
  for (const core::Ring& ring : a.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point from = ring[i], to = ring[(i + 1) % ring.size()];
      const int parts = 1 + static_cast<int>(core::distance_mm(from, to) / 0.02);
      for (int part = 0; part < parts; ++part) {
        const Point p = core::between(from, to, part / static_cast<double>(parts));
        farthest = std::max(farthest, std::abs(test::signed_distance(b, p.x, p.y)));
      }
    }
  }
  return farthest;
}

}  // namespace

TEST_CASE("a square and a smaller one are a leash apart that reaches its corners") {
  const Region outer = region_from_text("0:0 10:0 10:10 0:10");
  const Region inner = region_from_text("1:1 9:1 9:9 1:9");
  CHECK(frechet_within(outer, inner, Length::from_mm(1.4143)));
  CHECK_FALSE(frechet_within(outer, inner, Length::from_mm(1.4141)));
  CHECK(frechet_within(inner, outer, Length::from_mm(1.4143)));
  CHECK(frechet_within(outer, outer, Length()));
}

TEST_CASE("corners that one contour has and the other has not make no difference") {
  const Region few = region_from_text("0:0 10:0 10:10 0:10");
  const Region many = region_from_text("0.1:0.1 3:0.1 3.1:0.1 9.9:0.1 9.9:4 9.9:9.9 0.1:9.9 0.1:2");
  CHECK(frechet_within(few, many, Length::from_mm(0.15)));
  CHECK(frechet_within(many, few, Length::from_mm(0.15)));
}

TEST_CASE("a tongue that one of them lacks makes the leash taut, and so does a ring") {
  const Region tongue = region_from_text("0:0 10:0 10:4 14:4 14:5 10:5 10:10 0:10");
  const Region without = region_from_text("0.5:0.5 9.5:0.5 9.5:9.5 0.5:9.5");
  CHECK_FALSE(frechet_within(tongue, without, Length::from_mm(3)));
  const Region holed = region_from_text("0:0 10:0 10:10 0:10, 4:4 4:6 6:6 6:4");
  CHECK_FALSE(frechet_within(holed, without, Length::from_mm(20)));
}

TEST_CASE("rings that come in another order each have one of their own") {
  // One above another: whichever starts a little further left comes first.
  const Region low_first = region_from_text("0:0 2:0 2:2 0:2, 0.1:4 2:4 2:6 0.1:6, 9:0 11:0 11:2");
  const Region high_first = region_from_text("0:4 2:4 2:6 0:6, 0.1:0 2:0 2:2 0.1:2, 9:0 11:0 11:2");
  CHECK(frechet_within(low_first, high_first, Length::from_mm(0.1)));
  CHECK(frechet_within(high_first, low_first, Length::from_mm(0.1)));
  CHECK_FALSE(frechet_within(low_first, high_first, Length::from_mm(0.09)));
  // Not where two of them are near the same one, or one is near none.
  const Region twice =
      region_from_text("0.9:0.4 1.1:0.4 1.1:0.6 0.9:0.6, 0.9:1 1.1:1 1.1:1.2 0.9:1.2");
  const Region both = region_from_text("0.5:0 1.5:0 1.5:1.5 0.5:1.5, 0.5:9 1.5:9 1.5:10");
  REQUIRE(frechet_within(core::Region::from_clean_rings({twice.rings()[1]}),
                         core::Region::from_clean_rings({both.rings()[0]}), Length::from_mm(2)));
  CHECK_FALSE(frechet_within(twice, both, Length::from_mm(2)));
  CHECK_FALSE(frechet_within(both, twice, Length::from_mm(2)));
  const Region moved = region_from_text("0:14 2:14 2:16 0:16, 0.1:0 2:0 2:2 0.1:2, 9:0 11:0 11:2");
  CHECK_FALSE(frechet_within(low_first, moved, Length::from_mm(1)));
}

TEST_CASE("what is said to be frechet_within is near, on random regions and their offsets") {
  constexpr std::uint64_t kSeed = 20261126;
  CAPTURE(kSeed);
  Random random(kSeed);
  core::PolygonOffsetter offsetter;
  int said = 0;
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    const Region region = test::random_region(random, 20 + i, 20);
    const Length depth = Length::from_mm(random.between(0.05, 0.8));
    const Region inner = core::flatten(offsetter.offset(region, depth), Length::from_units(25));
    const Length reach = Length::from_mm(depth.mm() * random.between(1, 4));
    if (!frechet_within(region, inner, reach)) continue;
    ++said;
    CHECK_LE(farthest_units(region, inner), static_cast<double>(reach.units()) + 1);
  }
  MESSAGE("frechet_within: " << said << " of 200");
  CHECK_GE(said, 20);
}

TEST_CASE("what the leash does not prove is looked at place by place") {
  const Region square = region_from_text("0:0 10:0 10:10 0:10");
  const Region more = region_from_text("0.1:0.1 9.9:0.1 9.9:9.9 0.1:9.9, 4:4 4:6 6:6 6:4");
  const Region tongue = region_from_text("0:0 10:0 10:4 14:4 14:5 10:5 10:10 0:10");
  const Length reach = Length::from_mm(0.2), step = Length::from_mm(0.5);
  REQUIRE_FALSE(frechet_within(square, more, reach));
  CHECK(core::stays_near(square, more, reach, step));
  CHECK_FALSE(core::stays_near(more, square, reach, step));
  CHECK_FALSE(core::stays_near(tongue, square, reach, step));
}
