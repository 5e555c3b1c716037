// The skirt: loops round the first layer that prime the nozzle before the part starts.
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings
#include "core/units.h"           // Length

namespace core {

// Loop i (from 0), its bead's inner edge skirt_distance + i spacings outside the slice; around
// islands nearer to each other than twice that there is one common loop.
[[nodiscard]] std::vector<Road> skirt_roads(const Region& slice, Length height,
                                            const Settings& settings);

}  // namespace core
