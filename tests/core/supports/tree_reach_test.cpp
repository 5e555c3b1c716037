// What branches avoid, held against its formula, point by point, and over many layers.
#include "core/supports/tree_reach.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/regions/point_location.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"
#include "tests/support/tree_stacks.h"

using namespace core;

namespace {

// Of what is blocked, in units.
constexpr double kBlockedUnits = 800;

double mm(double units) { return units / kUnitsPerMm; }

}  // namespace

TEST_CASE("what is avoided is the slice, as far as a branch keeps off it, and its shadow") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const Settings settings = test::tree_settings(SupportPlace::kBed);
    const std::vector<Region> slices = test::ledges(seed, 40);
    const std::vector<SharedRegion> avoided = test::avoided_in(slices, settings);
    const double step = static_cast<double>(branch_step(settings.layer_height, settings).units());
    const double off =
        static_cast<double>((settings.support_xy_distance + branch_core(settings)).units());
    test::Random random(seed);
    int shadowed = 0;
    for (int i = 0; i < 4'000; ++i) {
      const auto n = static_cast<std::size_t>(random.integer(1, 39));
      const double x = random.between(5, 75) * kUnitsPerMm, y = random.between(5, 75) * kUnitsPerMm;
      CAPTURE(n);
      CAPTURE(mm(x));
      CAPTURE(mm(y));
      // Positive inside.
      const double here = test::signed_distance(*avoided[n], x, y);
      const double below = test::signed_distance(*avoided[n - 1], x, y);
      const double slice = test::signed_distance(slices[n], x, y);
      if (here < 0) {
        CHECK_LE(below, step);     // there is a way down
        CHECK_LE(slice, 1 - off);  // and nothing near
      } else if (slice < -off - kBlockedUnits) {
        CHECK_GE(below, 0.985 * step);  // there was none
        ++shadowed;
      }
    }
    CHECK_GT(shadowed, 20);
  }
}

TEST_CASE("what is free grows alike in all directions, a step a layer less one hundredth at most") {
  // A square hole in a plate: above it, branches may spread.
  Settings settings = test::tree_settings(SupportPlace::kBed, 0.05);
  settings.bed_x = settings.bed_y = Length::from_mm(400);
  const Region plate =
      subtract(test::rectangle_region(10, 10, 380, 380), test::rectangle_region(198, 198, 4, 4));
  TreeReach reach(settings);
  SharedRegion avoided = reach.push(plate, settings.layer_height);
  const double first = test::signed_distance(*avoided, 200 * kUnitsPerMm, 200 * kUnitsPerMm);
  CHECK_LT(first, 0);
  const int layers = 1'000;
  for (int i = 0; i < layers; ++i) avoided = reach.push({}, settings.layer_height);
  const double grown =
      layers * static_cast<double>(branch_step(settings.layer_height, settings).units());
  CHECK_GT(mm(grown), 41);
  // From the edge's middle and from the corner of what was free on the bed, outwards.
  const double half = -first;
  for (const double degrees : {0.0, 45.0, 60.0, 68.0, 80.0, 90.0, 225.0}) {
    CAPTURE(degrees);
    const double x = std::cos(degrees * M_PI / 180), y = std::sin(degrees * M_PI / 180);
    double low = 0, high = 2 * grown;
    for (int i = 0; i < 40; ++i) {
      const double at = (low + high) / 2;
      const Point point{static_cast<std::int32_t>(200 * kUnitsPerMm + at * x),
                        static_cast<std::int32_t>(200 * kUnitsPerMm + at * y)};
      (avoided->contains(point) ? high : low) = at;
    }
    // The distance of that place from the square.
    const double out_x = std::max(std::abs(low * x) - half, 0.0);
    const double out_y = std::max(std::abs(low * y) - half, 0.0);
    const double went = std::hypot(out_x, out_y);
    CHECK_LT(went, grown + 20);
    CHECK_GT(went, 0.99 * grown);
  }
}

TEST_CASE("a stack that doesn't change is looked at once") {
  const Settings settings = test::tree_settings(SupportPlace::kBed);
  TreeReach reach(settings);
  const Region slice = test::rectangle_region(20, 20, 10, 10);
  const SharedRegion first = reach.push(slice, settings.layer_height);
  CHECK_EQ(reach.push(slice, settings.layer_height), first);
  // A ledge's shadow ends after some layers, too.
  static_cast<void>(reach.push(test::rectangle_region(15, 15, 20, 20), settings.layer_height));
  SharedRegion last;
  for (int i = 0; i < 60; ++i) last = reach.push(slice, settings.layer_height);
  CHECK_EQ(reach.push(slice, settings.layer_height), last);
  CHECK(*last == *first);
}
