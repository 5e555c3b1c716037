// The beads that lie along the medial axis, where an odd number of beads lies side by side.
//
// Where three of them meet, the two that go straight on are one road, and the third ends at its
// side. Where more beads begin to lie side by side, the bead runs into the place until it touches
// the next bead of the contours, which goes across there. Where fewer do, it goes on for half of
// the transition, so that what it lays is what the others leave free.
//
//          ╲          across      A bead's share of the room ends where the next one's begins, so
//     ══════╪═╮ ◀──── the axis    that the volume is right.
//      ▲   ╱  │
//      └ ends half a bead before
#pragma once

#include <vector>

#include "core/roads/axis_graph.h"  // AxisGraph
#include "core/roads/bead_lines.h"  // BeadLine
#include "core/roads/beading.h"     // Beading

namespace core {

// REQUIRES: decide_bead_counts() was called.
// ENSURES: rooms of beading.room_min() or more; two points or more, three where closed.
// COSTS: O(edges).
[[nodiscard]] std::vector<BeadLine> centre_beads(const Beading& beading, const AxisGraph& graph);

}  // namespace core
