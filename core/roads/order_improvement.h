// Makes the travel between roads in an order less, by local search:
//
//     2-opt     a run of roads is laid the other way round
//     Or-opt    a run of up to kMovedRoadsMax roads is laid elsewhere, either way round
//
// SOURCE: Croes, "A method for solving traveling-salesman problems", 1958; Or, 1976. A nearest-end
// order leaves single roads behind, which it must come back for: these moves bring them in.
//
// A travel costs its length, and kStopMm where it is longer than a short way: those are laid
// (short_ways.h), so that the nozzle doesn't stop there.
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

// What stopping and starting cost, as a length of travel.
inline constexpr double kStopMm = 3;

// Changes the order of the roads, and the way round of open ones; closed ones start where they did.
// The way begins at `from` and ends anywhere.
// ENSURES: travel_cost_mm() is no more than before; the same roads give the same order.
// COSTS: O(roads · kOrderReach) for each of at most kOrderPassesMax passes.
void improve_order(std::vector<Road>& roads, Point from);

// Cost of the travel from `from` to the first road, and from each to the next.
[[nodiscard]] double travel_cost_mm(const std::vector<Road>& roads, Point from);

// Its length.
[[nodiscard]] double travel_mm(const std::vector<Road>& roads, Point from);

}  // namespace core
