#include "core/roads/hanging_places.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "core/booleans/boolean.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

HangingPlaces places(const Region& slice, const Region& below, const Settings& settings = {}) {
  SplitLayer layer;
  layer.slice.region = slice;
  layer.slice.height = layer.below_height = settings.layer_height;
  layer.below = std::make_shared<const Region>(below);
  return hanging_places(layer, settings);
}

std::int64_t count(const HangingPlaces& found, HangingKind kind) {
  return found.counts[static_cast<std::size_t>(kind)];
}

}  // namespace

TEST_CASE("an island over nothing begins in the air; one that touches does not") {
  const Region post = test::rectangle_region(0, 0, 5, 20);
  const HangingPlaces found = places(unite(post, test::rectangle_region(15, 5, 5, 10)), post);
  REQUIRE_EQ(found.largest.size(), 1);
  CHECK_EQ(found.largest.front().kind, HangingKind::kIsland);
  CHECK_EQ(found.largest.front().size, doctest::Approx(50));
  CHECK_EQ(found.largest.front().at, Point{175'000, 100'000});
  CHECK_EQ(count(places(test::rectangle_region(0, 0, 8, 20), post), HangingKind::kIsland), 0);
  CHECK(places(post, post).largest.empty());
  SplitLayer first;
  first.slice.region = post;
  CHECK(hanging_places(first, Settings()).largest.empty());
}

TEST_CASE("a bridge is told where it is longer than bridge_max") {
  Settings settings;
  for (const double span : {5.0, 9.9, 10.1, 40.0}) {
    CAPTURE(span);
    const Region below =
        unite(test::rectangle_region(0, 0, 4, 10), test::rectangle_region(4 + span, 0, 4, 10));
    const HangingPlaces found = places(test::rectangle_region(0, 0, span + 8, 10), below, settings);
    CHECK_EQ(count(found, HangingKind::kSpan), span > 10 ? 1 : 0);
    CHECK_EQ(count(found, HangingKind::kOverhang), 0);
    if (span > 10) CHECK_EQ(found.largest.front().size, doctest::Approx(span));
  }
  settings.bridge_max = Length::from_mm(42);
  const Region below =
      unite(test::rectangle_region(0, 0, 4, 10), test::rectangle_region(44, 0, 4, 10));
  CHECK(places(test::rectangle_region(0, 0, 48, 10), below, settings).largest.empty());
}

TEST_CASE("an overhang is told where it is steeper than overhang_angle_degrees") {
  Settings settings;
  for (const double angle : {30.0, 45.0, 60.0}) {
    settings.overhang_angle_degrees = angle;
    for (const double degrees : {20.0, 40.0, 44.0, 46.0, 59.0, 62.0, 80.0}) {
      CAPTURE(angle);
      CAPTURE(degrees);
      const double step = 0.2 * std::tan(degrees * std::numbers::pi / 180);
      const HangingPlaces found = places(test::rectangle_region(0, 0, 20 + step, 20),
                                         test::rectangle_region(0, 0, 20, 20), settings);
      // Hairs are rounding.
      const double beyond = step - 0.2 * std::tan(angle * std::numbers::pi / 180);
      if (beyond > 0 && beyond < 0.04) continue;
      CHECK_EQ(count(found, HangingKind::kOverhang), beyond > 0 ? 1 : 0);
    }
  }
}

TEST_CASE("of many places the largest are kept, and all are counted") {
  Region slice = test::rectangle_region(0, 0, 5, 5);
  const Region below = slice;
  for (int i = 1; i <= 9; ++i)
    slice = unite(slice, test::rectangle_region(10.0 * i, 0, 1 + i * 0.1, 1));
  const HangingPlaces found = places(slice, below);
  CHECK_EQ(count(found, HangingKind::kIsland), 9);
  REQUIRE_EQ(found.largest.size(), kHangingPlacesMax);
  CHECK_EQ(found.largest.front().size, doctest::Approx(1.9));
}
