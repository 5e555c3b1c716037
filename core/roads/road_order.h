// Puts roads in printing order, each next to the end of the one before, so that the nozzle travels
// little.
//
// An open road starts at either end. A closed road starts, and ends, at its seam: at one of
// Road::starts (seams.h); where there are none, at a corner where it has one, otherwise at any
// vertex.
//
// Keywords: seam, travel, tool path order.
#pragma once

#include <vector>

#include "core/geometry.h"           // Point
#include "core/roads/layer_roads.h"  // IslandRoads, LayerRoads
#include "core/roads/road.h"         // Road

namespace core {

// The roads in order, starting at the one nearest to `at`. Roads are turned, or start at another
// point, where that is nearer. `at` moves to the end of the last road.
// COSTS: O(points), and some O(1) a road for the next one, by a grid of the points to start at.
[[nodiscard]] std::vector<Road> nearest_order(std::vector<Road> roads, Point& at);

// All roads of a layer: its first ones, then island by island the inner perimeters, the outer ones
// (before them where wanted, but for those that overhang), bottoms, the wall with its bridges and
// its gap fill and the inside as they are near one another, the perimeters of holes in bridges,
// tops, ironing. Bottoms, tops and ironing keep their order.
// COSTS: as nearest_order().
[[nodiscard]] std::vector<Road> printing_order(LayerRoads layer);

}  // namespace core
