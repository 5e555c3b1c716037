// Which acceleration the machine is told for a road, and for travel. What has none of its own has
// that of the next in this order, as in PrusaSlicer:
//
//     first layer ─▶ bridge ──────────────┐
//                    outer perimeter ─▶ perimeter ──▶ default
//                    top, ironing ─▶ solid ─▶ loose ─┘
//
// Without a default nothing is told, and every move has the machine's own.
#pragma once

#include "core/roads/road.h"  // RoadKind
#include "core/settings.h"    // Settings
#include "core/units.h"       // LayerIndex, Length

namespace core {

// In whole mm/s², at least 1; 0: none is told. `top`: of the layer (height_slowdown.h).
[[nodiscard]] double road_acceleration_mm_s2(const Settings& settings, LayerIndex layer, Length top,
                                             RoadKind kind);

// Likewise; 0: travel has that of the road before it.
[[nodiscard]] double travel_acceleration_mm_s2(const Settings& settings, Length top);

}  // namespace core
