#include "core/roads/solid_areas.h"

#include <doctest/doctest.h>

#include <memory>

#include "core/booleans/boolean.h"
#include "core/offsets/voronoi_mountain.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

std::shared_ptr<const Region> shared(const Region& region) {
  return std::make_shared<const Region>(region);
}

SplitLayer layer_of(const Region& slice, std::shared_ptr<const Region> below,
                    std::shared_ptr<const Region> above) {
  SplitLayer layer;
  layer.slice.region = slice;
  layer.below = std::move(below);
  layer.above = std::move(above);
  return layer;
}

}  // namespace

TEST_CASE("between equal slices all is wall; under the sky it is top, on the bed bottom") {
  const Region square = test::region_from_text("0:0 20:0 20:20 0:20");
  const auto same = shared(square);
  const SolidAreas within = solid_areas(square, layer_of(square, same, same), Settings());
  CHECK(within.top.empty());
  CHECK(within.bottom.empty());
  CHECK_EQ(within.between, square);
  const SolidAreas last = solid_areas(square, layer_of(square, same, nullptr), Settings());
  CHECK_EQ(last.top, square);
  CHECK(last.between.empty());
  const SolidAreas first = solid_areas(square, layer_of(square, nullptr, same), Settings());
  CHECK_EQ(first.bottom, square);
  CHECK(first.between.empty());
}

TEST_CASE("a step is top where it is wider than three roads, and half as far under what is above") {
  const Region square = test::region_from_text("0:0 20:0 20:20 0:20");
  for (const double step : {0.5, 1.0, 1.3, 1.4, 3.0}) {
    CAPTURE(step);
    Region above = test::region_from_text("0:0 20:0 20:20 0:20");
    const auto x = static_cast<std::int32_t>(step * 10'000);
    above = Region::from_clean_rings({{{x, 0}, {200'000, 0}, {200'000, 200'000}, {x, 200'000}}});
    const SolidAreas areas =
        solid_areas(square, layer_of(square, shared(square), shared(above)), Settings());
    if (step < 1.35) {
      CHECK(areas.top.empty());
      continue;
    }
    CHECK_EQ(areas.top.box().max.x, doctest::Approx(x + 6'750).epsilon(0.02));
    CHECK(areas.top.contains({x / 2, 100'000}));
    CHECK(areas.top.area_mm2() + areas.between.area_mm2() == doctest::Approx(400).epsilon(1e-6));
  }
}

TEST_CASE("random layers: the areas are the wall, disjoint; what is deep in the open is top") {
  Settings settings;
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region slice = test::random_region(random, 50, 40);
    const Region above = test::random_region(random, 50, 40);
    const Region below = test::random_region(random, 50, 40);
    const SolidAreas areas =
        solid_areas(slice, layer_of(slice, shared(below), shared(above)), settings);
    CHECK(areas.top.area_mm2() + areas.bottom.area_mm2() + areas.between.area_mm2() ==
          doctest::Approx(slice.area_mm2()).epsilon(1e-5));
    CHECK(test::is_clean(areas.top));
    CHECK(test::is_clean(areas.bottom));
    const Region deep =
        offset(subtract(slice, above), Length::from_mm(0.7), settings.arc_tolerance);
    CHECK_LE(subtract(deep, areas.top).area_mm2(), 1e-3);
    const Region open_below = subtract(subtract(slice, areas.top), below);
    const Region deep_below = offset(open_below, Length::from_mm(0.7), settings.arc_tolerance);
    CHECK_LE(subtract(deep_below, areas.bottom).area_mm2(), 1e-3);
  }
}
