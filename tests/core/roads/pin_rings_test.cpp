#include "core/roads/pin_rings.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/booleans/boolean.h"
#include "core/offsets/slice_offsets.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

const Length kHeight = Length::from_mm(0.2);

// Its corners on a circle.
Region polygon(int corners, double radius_mm, double turn = 0.1) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2 * std::numbers::pi * i / corners;
    ring.push_back({static_cast<std::int32_t>(std::lround(radius_mm * std::cos(angle) * 1e4)),
                    static_cast<std::int32_t>(std::lround(radius_mm * std::sin(angle) * 1e4))});
  }
  return Region::from_clean_rings({ring});
}

double volume_mm3(const std::vector<Road>& roads) {
  double sum = 0;
  for (const Road& road : roads) sum += core::volume_mm3(road, kHeight);
  return sum;
}

}  // namespace

TEST_CASE("rings fill a pin exactly, and no bead leaves it") {
  for (const int perimeters : {1, 2, 4}) {
    Settings settings;
    settings.perimeters = perimeters;
    const double spacing = perimeter_spacing(settings, kHeight).mm();
    for (const int corners : {4, 5, 6, 8, 24, 96}) {
      for (double radius = 0.3; radius < 2.4; radius += 0.07) {
        CAPTURE(perimeters);
        CAPTURE(corners);
        CAPTURE(radius);
        const Region pin = polygon(corners, radius);
        const auto rings = pin_rings(pin, kHeight, settings);
        // Up to half a ring more than there are perimeters.
        const double inner = radius * std::cos(std::numbers::pi / corners) - 0.0215;
        const double most = (perimeters + 0.5) * spacing;
        if (inner > most + 0.01) CHECK_FALSE(rings.has_value());
        if (inner > most - 0.01) continue;
        REQUIRE(rings.has_value());
        CHECK_LE(rings->size(), static_cast<std::size_t>(perimeters));
        // A bead's round sides leave a rim along the contour.
        const double rim = kHeight.mm() * kHeight.mm() * (1 - std::numbers::pi / 4) / 2;
        const double asked = pin.area_mm2() * kHeight.mm() - pin.perimeter_mm() * rim;
        CHECK_EQ(volume_mm3(*rings), doctest::Approx(asked).epsilon(0.015));
        for (const Road& road : *rings) {
          CHECK_GE(road.width, settings.road_width_min);
          CHECK_LE(road.width.mm(), 1.6 * settings.road_width.mm());
          for (const Point at : road.points) {
            CHECK_GT(test::signed_distance(pin, at.x, at.y),
                     static_cast<double>(road.width.units()) / 2 - 30);
          }
        }
      }
    }
  }
}

TEST_CASE("what is long, pointed, holed, or too thin for a road is no pin") {
  const Settings settings;
  CHECK_FALSE(pin_rings(test::rectangle_region(0, 0, 1, 2), kHeight, settings).has_value());
  CHECK_FALSE(pin_rings(polygon(3, 0.9), kHeight, settings).has_value());
  CHECK_FALSE(pin_rings(polygon(24, 0.15), kHeight, settings).has_value());
  CHECK_FALSE(
      pin_rings(subtract(polygon(24, 0.9), polygon(24, 0.3)), kHeight, settings).has_value());
  const Region bean = test::region_from_text("0:0 1:0 1:1 0.6:1 0.6:0.4 0.4:0.4 0.4:1 0:1");
  CHECK_FALSE(pin_rings(bean, kHeight, settings).has_value());
  Settings none;
  none.perimeters = 0;
  CHECK_FALSE(pin_rings(polygon(24, 0.4), kHeight, none).has_value());
}
