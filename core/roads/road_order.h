// Puts roads in printing order, each next to the end of the one before, so that the nozzle travels
// little.
//
// An open road starts at either end. A closed road starts, and ends, at its seam: at a corner where
// it has one, so that the seam hides there, otherwise at any vertex.
//
// Keywords: seam, travel, tool path order.
#pragma once

#include <vector>

#include "core/geometry.h"        // Point
#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road

namespace core {

// The roads in order, starting at the one nearest to `at`. Roads are turned, or start at another
// point, where that is nearer. `at` moves to the end of the last road.
// COSTS: O(points), and some O(1) a road for the next one, by a grid of the points to start at.
[[nodiscard]] std::vector<Road> nearest_order(std::vector<Road> roads, Point& at);

// All roads of a layer, island by island of the slice: the inner perimeters, the outer ones, the
// wall with its gap fill, the inside.
// COSTS: as nearest_order(), and a look at each island's box for each road.
[[nodiscard]] std::vector<Road> printing_order(std::vector<Road> roads, const Region& slice,
                                               Point at);

}  // namespace core
