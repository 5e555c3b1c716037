// How a controller plans moves: what it is allowed, and what corners cost.
//
// One description for every clock: that of a plan and of a ready file (motion_clock.h), and the
// virtual controller's, which plans by an arithmetic of its own.
#pragma once

#include <array>
#include <cstddef>

#include "core/settings.h"  // Settings

namespace core {

// x, y, z, filament.
inline constexpr std::size_t kMotionAxes = 4;
using AxisLimits = std::array<double, kMotionAxes>;

struct MotionModel {
  double acceleration_mm_s2;             // until it is told another. REQUIRES: > 0
  double filament_acceleration_mm_s2;    // of moves of the filament alone. REQUIRES: > 0
  double travel_acceleration_mm_s2 = 0;  // of moves without filament; 0: as others

  // M203, M201: by axis; 0: not limited.
  AxisLimits speed_max_mm_s{};
  AxisLimits acceleration_max_mm_s2{};

  // Corners: by the first of these that is not 0.
  AxisLimits jerk_mm_s{};            // M205 X Y Z E: the change of speed of one axis; x counts
  double square_corner_mm_s = 0;     // Klipper: the speed through a right angle
  double junction_deviation_mm = 0;  // M205 J. REQUIRES: ≥ 0

  [[nodiscard]] bool jerks() const { return jerk_mm_s[0] > 0; }
  bool operator==(const MotionModel&) const = default;
};

// The model of the settings' machine, as it is switched on.
[[nodiscard]] MotionModel motion_model(const Settings& settings);

}  // namespace core
