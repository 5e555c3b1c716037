// The skirt: loops round the first layer that prime the nozzle before the part starts.
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings
#include "core/units.h"           // Length

namespace core {

// Loops are laid until they are as long as skirt_length_min asks, but no more than these.
inline constexpr int kSkirtLoopsMax = 100;

// Loop i (from 0), its bead's inner edge skirt_distance + i spacings outside the slice and its
// brim; around islands nearer to each other than twice that there is one common loop. The farthest
// come first. No loops where skirt_loops is 0.
[[nodiscard]] std::vector<Road> skirt_roads(const Region& slice, Length height,
                                            const Settings& settings);

}  // namespace core
