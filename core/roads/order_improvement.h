// Makes the travel between roads in an order shorter, by local search:
//
//     2-opt     a run of roads is laid the other way round
//     Or-opt    a run of up to kMovedRoadsMax roads is laid elsewhere, either way round
//
// SOURCE: Croes, "A method for solving traveling-salesman problems", 1958; Or, 1976. A nearest-end
// order leaves single roads behind, which it must come back for: these moves bring them in.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry.h"    // Point
#include "core/roads/road.h"  // Road

namespace core {

// The longest run that is turned, and how far a run is moved, in roads.
inline constexpr std::size_t kOrderReach = 100;
inline constexpr std::size_t kMovedRoadsMax = 3;
inline constexpr int kOrderPassesMax = 3;

// Changes the order of the roads, and the way round of open ones; closed ones start where they did.
// The way begins at `from` and ends anywhere.
// ENSURES: no more travel than before; the same roads give the same order.
// COSTS: O(roads · kOrderReach) for each of at most kOrderPassesMax passes.
void improve_order(std::vector<Road>& roads, Point from);

// Travel from `from` to the first road, and from each to the next.
[[nodiscard]] double travel_mm(const std::vector<Road>& roads, Point from);

}  // namespace core
