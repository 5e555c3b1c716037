// How fast a road may be laid, before its layer is slowed down (cooling.h).
#pragma once

#include "core/roads/road.h"  // Road
#include "core/settings.h"    // Settings
#include "core/units.h"       // LayerIndex

namespace core {

// Closed perimeters up to this length are small: a circle of 6.5 mm radius, as in PrusaSlicer.
inline constexpr double kSmallPerimeter_mm = 40.84;

// Ask it of the whole road, before it is opened at its seam.
[[nodiscard]] bool is_small_perimeter(const Road& road);

// What is laid of a road's cross-section: the filament's and the layer's multipliers.
[[nodiscard]] double flow_factor(const Settings& settings, LayerIndex layer);

// What of a road decides its speed.
struct RoadSpeedCase {
  RoadKind kind = RoadKind::kSolid;
  bool small = false;  // a small perimeter
  Hold hold = Hold::kWhole;
  double area_mm2 = 0;  // its cross-section
};

// The least of what the kind of road, its size, what holds it, its flow and the first layer allow.
// The part's first layer over a raft's gap is as slow as that on the bed.
// ENSURES: above 0.
[[nodiscard]] double full_speed_mm_s(const Settings& settings, LayerIndex layer,
                                     const RoadSpeedCase& road);

// The least share of the fan that a stretch of road needs, where the fan is on.
[[nodiscard]] double fan_share_least(const Settings& settings, RoadKind kind, Hold hold);

}  // namespace core
