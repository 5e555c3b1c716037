#include "core/offsets/capsule_offset.h"

#include <doctest/doctest.h>

#include "core/limits.h"
#include "core/offsets/polygon_offset.h"
#include "tests/support/grid_regions.h"
#include "tests/support/offset_checks.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Length;
using core::Region;
using test::Random;

namespace {

const Length kTolerance =
    Length::from_units(static_cast<std::int64_t>(core::kCapsuleToleranceUnits));

}  // namespace

TEST_CASE("points are judged rightly by measured distances, inwards and outwards") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_grid_region(random, 4'000);
    if (region.empty()) continue;
    for (const double depth_mm : {0.3, 1.0, -0.4, -2.0}) {
      CAPTURE(depth_mm);
      const Length depth = Length::from_mm(depth_mm);
      const Region result = core::capsule_offset(region, depth);
      CHECK(test::is_clean(result));
      CHECK_EQ(test::misjudged_points(region, depth, result, random, 100, kTolerance), 0);
    }
  }
}

TEST_CASE("it is the polygon offset, but for its coarser chords") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_region(random, 60, 20);
    for (const double depth_mm : {0.5, -0.5}) {
      const Length depth = Length::from_mm(depth_mm);
      const Region ours = core::flatten(core::PolygonOffsetter().offset(region, depth), kTolerance);
      CHECK_LE(test::widest_difference(core::capsule_offset(region, depth), ours),
               2 * core::kCapsuleToleranceUnits);
    }
  }
}

TEST_CASE("an inset of half a square's side, and more, is empty") {
  const Region square = test::region_from_text("0:0 4:0 4:4 0:4");
  CHECK(core::capsule_offset(square, Length::from_mm(2.001)).empty());
  CHECK(core::capsule_offset(square, Length::from_mm(30)).empty());
}
