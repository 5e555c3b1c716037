// The brim: loops on the bed that touch the first layer's contours, or nearly, and hold it down.
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings
#include "core/units.h"           // Length

namespace core {

// How far the brim reaches from the contours; 0 where there is none outside.
[[nodiscard]] Length brim_reach(const Settings& settings);

// Loop i (from 0), its bead's inner edge brim_gap + i spacings away from the slice. The farthest
// come first. Where islands, or the sides of a hole, are nearer to each other, loops meet or end.
[[nodiscard]] std::vector<Road> brim_roads(const Region& slice, Length height,
                                           const Settings& settings);

}  // namespace core
