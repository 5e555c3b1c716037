// Wiping: the nozzle moves over the road just laid while the filament is drawn back, so that what
// still oozes ends up on that road.
//
//     open road     ────────────────▶┐      back over it
//                             ◀──────┘
//     closed road   ╭──▶──╮                 on over its start
//                   ╰──▲──╯
#pragma once

#include <vector>

#include "core/geometry.h"  // Point
#include "core/settings.h"  // Settings

namespace core {

// How one retraction is shared out.
struct WipePlan {
  double before_mm = 0;        // filament that is drawn back before the nozzle moves
  double filament_per_mm = 0;  // that is drawn back along the way
  double speed_mm_s = 0;       // of the nozzle
  std::vector<Point> way;      // from where the nozzle is, over the road; empty: no wipe
};

// `road`: the points of the road just laid, from its start to where the nozzle is, or to just
// before its start where `loop`. The way ends where the road does; what it is too short for is
// drawn back before.
// ENSURES: before_mm + filament_per_mm · the way's length = retraction_mm; along the way, filament
// is at most as fast as retraction_speed_mm_s, the nozzle as 4/5 of travel_speed_mm_s; the way is
// within segment_tolerance of the road. COSTS: O(points passed).
[[nodiscard]] WipePlan wipe_plan(const std::vector<Point>& road, bool loop,
                                 const Settings& settings);

}  // namespace core
