#include "core/supports/hanging_regions.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/booleans/boolean.h"
#include "core/offsets/voronoi_mountain.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;
using test::rectangle_region;

namespace {

HangingRegions hanging(const Region& slice, const Region& below, const Settings& settings = {}) {
  return hanging_regions(slice, below, settings.layer_height, settings);
}

Region disc(double x_mm, double y_mm, double radius_mm, int corners = 48) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back(
        {static_cast<std::int32_t>(std::lround((x_mm + radius_mm * std::cos(angle)) * 1e4)),
         static_cast<std::int32_t>(std::lround((y_mm + radius_mm * std::sin(angle)) * 1e4))});
  }
  return Region::from_clean_rings({ring});
}

}  // namespace

TEST_CASE("a slope hangs where it is steeper than the angle, back to the slice below") {
  const Region below = rectangle_region(0, 0, 30, 20);
  for (const double degrees : {30.0, 44.0, 46.0, 60.0, 75.0}) {
    CAPTURE(degrees);
    const double out = 0.2 * std::tan(degrees * std::numbers::pi / 180);
    const HangingRegions found = hanging(rectangle_region(0, 0, 30 + out, 20), below);
    CHECK(found.islands.empty());
    const double area = found.overhangs.area_mm2();
    // Steeper than 45° and a hair.
    CHECK_EQ(area, doctest::Approx(degrees > 47 ? out * 20 : 0).epsilon(0.02));
  }
  Settings steep;
  steep.overhang_angle_degrees = 70;
  const double out = 0.2 * std::tan(60 * std::numbers::pi / 180);
  CHECK(hanging(rectangle_region(0, 0, 30 + out, 20), below, steep).empty());
}

TEST_CASE("an island is held all over; one that touches the slice below is none") {
  const Region post = rectangle_region(0, 0, 5, 20), island = rectangle_region(15, 5, 5, 10);
  const HangingRegions found = hanging(unite(post, island), post);
  CHECK(found.islands == island);
  CHECK(found.overhangs.empty());
  CHECK(hanging(post, post).empty());
}

TEST_CASE("a bridge needs no support, a longer span does, and so does a shelf") {
  for (const double span : {5.0, 9.5, 10.5, 30.0}) {
    CAPTURE(span);
    const Region below = unite(rectangle_region(0, 0, 4, 10), rectangle_region(4 + span, 0, 4, 10));
    const HangingRegions found = hanging(rectangle_region(0, 0, span + 8, 10), below);
    CHECK_EQ(found.overhangs.area_mm2(), doctest::Approx(span > 10 ? span * 10 : 0).epsilon(0.01));
  }
  const HangingRegions shelf =
      hanging(rectangle_region(0, 0, 12, 10), rectangle_region(0, 0, 5, 10));
  CHECK_EQ(shelf.overhangs.area_mm2(), doctest::Approx(70).epsilon(0.01));
}

TEST_CASE("of a bridge, perimeters that bend in the air are held") {
  // A slot under a deck whose edge bends over the slot.
  const Region below = unite(rectangle_region(0, 0, 4, 20), rectangle_region(12, 0, 4, 20));
  const Region deck = unite(rectangle_region(0, 0, 16, 14), rectangle_region(0, 0, 8, 20));
  const HangingRegions found = hanging(deck, below);
  CHECK(found.overhangs.contains({75'000, 195'000}));
  CHECK(found.overhangs.contains({75'000, 150'000}));
  // The straight edge on the other side holds.
  CHECK_FALSE(found.overhangs.contains({80'000, 10'000}));
  // A hole over the slot is held all around.
  const Region holed = subtract(rectangle_region(0, 0, 16, 20), disc(8, 10, 2));
  const HangingRegions around = hanging(holed, below);
  CHECK(around.overhangs.contains({80'000, 123'000}));
  CHECK(around.overhangs.contains({57'000, 100'000}));
}

TEST_CASE("fill in the air that is laid as no bridge is held, too") {
  const Region plate = rectangle_region(0, 0, 30, 30);
  for (const double breadth : {0.5, 0.8, 2.0}) {
    CAPTURE(breadth);
    const HangingRegions found =
        hanging(plate, subtract(plate, rectangle_region(14, 10, breadth, 12)));
    // Narrow ones are crossed by rows that lie on both sides; wide ones are bridged.
    CHECK_EQ(found.overhangs.empty(), breadth != 0.8);
  }
}

TEST_CASE("what hangs lies in the slice and outside the one below, whatever the part") {
  for (int turn = 0; turn < 12; ++turn) {
    CAPTURE(turn);
    const Region below = unite(disc(0, 0, 6 + turn * 0.1), disc(9, turn - 6.0, 3));
    const Region slice =
        subtract(unite(disc(1, 0.5, 7), disc(9, 4, 4)), disc(2, 2, turn * 0.3 + 0.5));
    const HangingRegions found = hanging(slice, below);
    for (const Region& region : {found.overhangs, found.islands}) {
      CHECK_LT(test::widest_difference(intersect(region, slice), region), 3);
      CHECK(intersect(region, below).area_mm2() < 1e-4);
    }
    CHECK(intersect(found.islands, found.overhangs).empty());
  }
}
