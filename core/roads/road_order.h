// Puts roads one after another by nearest end, so that the nozzle travels little.
//
// An open road is begun at either end. A closed one is begun at a corner where it has one, so that
// the seam hides there, otherwise at any vertex.
#pragma once

#include <vector>

#include "core/geometry.h"        // Point
#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road

namespace core {

// The roads in order, turned or begun elsewhere where that is nearer, from `at` on; `at` moves to
// the end of the last.
// COSTS: O(points) and some O(1) a road for the next one, by a grid of the points to begin at.
[[nodiscard]] std::vector<Road> nearest_order(std::vector<Road> roads, Point& at);

// All roads of a layer: island by island of the slice; on each the inner perimeters, the outer
// ones, the wall with its rests, the inside.
// COSTS: as nearest_order(), and a look at each island's box for each road.
[[nodiscard]] std::vector<Road> printing_order(std::vector<Road> roads, const Region& slice,
                                               Point at);

}  // namespace core
