#include "core/motions/road_speeds.h"

#include <doctest/doctest.h>

using namespace core;

namespace {

Road square(RoadKind kind, std::int32_t side_mm) {
  const std::int32_t s = side_mm * 10'000;
  return {kind, Length::from_mm(0.45), true, {{0, 0}, {s, 0}, {s, s}, {0, s}}};
}

constexpr LayerIndex kHigh = 10;
constexpr double kArea_mm2 = 0.08;

RoadSpeedCase case_of(const Road& road, Hold hold = Hold::kWhole) {
  return {road.kind, is_small_perimeter(road), hold, kArea_mm2};
}

}  // namespace

TEST_CASE("perimeters are slower the less of them is held, never faster than their kind") {
  Settings settings;
  settings.outer_perimeter_speed_mm_s = 50;
  const Road road = square(RoadKind::kOuterPerimeter, 20);
  const auto speed = [&](Hold hold) {
    return full_speed_mm_s(settings, kHigh, case_of(road, hold));
  };
  CHECK_EQ(speed(Hold::kWhole), 50);
  CHECK_EQ(speed(Hold::kThreeQuarters), 50);
  CHECK_EQ(speed(Hold::kHalf), 45);
  CHECK_EQ(speed(Hold::kQuarter), 30);
  CHECK_EQ(speed(Hold::kLittle), 20);
  settings.overhang_speed_mm_s.fill(0);
  CHECK_EQ(speed(Hold::kLittle), 50);
}

TEST_CASE("bridges have speeds and fans of their own") {
  Settings settings;
  settings.bridge_speed_mm_s = 25;
  settings.internal_bridge_speed_mm_s = 35;
  settings.bridge_fan_share = 0.7;
  settings.overhang_fan_share = {0.1, 0.2, 0.3, 0.4};
  const auto speed = [&](RoadKind kind) {
    return full_speed_mm_s(settings, kHigh, case_of(square(kind, 20)));
  };
  CHECK_EQ(speed(RoadKind::kBridge), 25);
  CHECK_EQ(speed(RoadKind::kInternalBridge), 35);
  CHECK_EQ(fan_share_least(settings, RoadKind::kBridge, Hold::kWhole), 0.7);
  CHECK_EQ(fan_share_least(settings, RoadKind::kOverhangPerimeter, Hold::kLittle), 0.4);
  CHECK_EQ(fan_share_least(settings, RoadKind::kOuterPerimeter, Hold::kThreeQuarters), 0.1);
  CHECK_EQ(fan_share_least(settings, RoadKind::kOuterPerimeter, Hold::kWhole), 0);
}

TEST_CASE("small perimeters, the flow and the first layer set limits") {
  Settings settings;
  const auto speed = [&](const Road& road, LayerIndex layer = kHigh) {
    return full_speed_mm_s(settings, layer, case_of(road));
  };
  const Road small = square(RoadKind::kOuterPerimeter, 10), wide = square(small.kind, 11);
  CHECK_EQ(speed(small), 60);
  settings.small_perimeter_speed_mm_s = 15;
  CHECK_EQ(speed(small), 15);
  CHECK_EQ(speed(wide), 60);
  CHECK_EQ(speed(square(RoadKind::kSolid, 10)), 60);
  settings.volumetric_speed_max_mm3_s = 4;
  CHECK_EQ(speed(wide), doctest::Approx(4 / kArea_mm2));
  settings.extrusion_multiplier = 2;
  CHECK_EQ(speed(wide), doctest::Approx(2 / kArea_mm2));
  CHECK_EQ(speed(wide, 0), doctest::Approx(2 / kArea_mm2));
  settings.first_layer_flow = 1.25;
  CHECK_EQ(speed(wide, 0), doctest::Approx(1.6 / kArea_mm2));
  CHECK_EQ(speed(wide), doctest::Approx(2 / kArea_mm2));
  settings.volumetric_speed_max_mm3_s = 0;
  CHECK_EQ(speed(wide, 0), settings.first_layer_speed_mm_s);
}
