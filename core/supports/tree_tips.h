// Where branches begin under a roof: under its rows, support_tip_spacing apart, and on its edge
// where no such place is near.
//
//     ┌───────────────┐
//     │   o   o   o   o     cells of a grid that is turned as the rows and fixed to the plane:
//     o   o   o   o   │     one tip each, at its middle, or where the edge is nearest to it
//     └─o─────────────┘
#pragma once

#include <vector>

#include "core/geometry.h"        // Point
#include "core/regions/region.h"  // Region
#include "core/settings.h"        // Settings
#include "core/units.h"           // Length

namespace core {

// In an order that depends on nothing else: middles of cells first. `height`: of the layer that the
// rows are in. COSTS: O(cells of the region's box + points + length of its edge).
[[nodiscard]] std::vector<Point> tip_places(const Region& region, Length height,
                                            const Settings& settings);

}  // namespace core
