// Stretches of a perimeter in the air that hold by themselves, and those that don't.
//
//      held ▒▒▒▒▒───────────▒▒▒▒▒ held       straight from one held place to another: a bridge
//      held ▒▒▒▒▒────────╮
//                        │                   cuts the corner: to be held
//      held ▒▒▒▒▒────────╯
#pragma once

#include <vector>

#include "core/geometry.h"                // Point, Ring
#include "core/regions/point_location.h"  // PointLocation
#include "core/settings.h"                // Settings
#include "core/units.h"                   // Length

namespace core {

// Shorter stretches hold, whatever their shape.
inline constexpr double kStretchHeld_mm = 0.6;

// A stretch this much longer than its chord is bent.
inline constexpr double kBentRatio = 1.03;

// The ring's stretches that nothing below holds and that are bent, longer than bridge_max, or all
// around. COSTS: O(length · strip).
[[nodiscard]] std::vector<std::vector<Point>> airborne_stretches(const Ring& ring,
                                                                 const PointLocation& below,
                                                                 const Settings& settings);

// Appends convex pieces whose union is the strip within `reach` of the lines, or nearly.
void add_strips(const std::vector<std::vector<Point>>& lines, Length reach,
                std::vector<Ring>& strips);

}  // namespace core
