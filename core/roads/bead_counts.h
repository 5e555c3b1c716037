// Decides how many beads lie side by side along the medial axis, and where that changes.
//
// Each piece of the central axis begins with the count that its room asks for. Pieces that are too
// short to print well give way (beading.h):
//
//     …2 │ 3 │ 4…    the room only grows: the wider neighbour's beads go on, until they meet
//     …2 │ 3 │ 2…    a bulge: its neighbours' beads fill it
//     …3 │ 2 │ 3…    a neck: they go on where it is hardly narrower
//
// Where two counts meet, the beads on one side move within kTransitionLength to where the other
// side has them: on the narrower side, if a bead along the axis begins on the wider one. A spur has
// the beads of the place where it leaves the central axis, as far as there is room for them.
#pragma once

#include "core/roads/axis_graph.h"  // AxisGraph
#include "core/roads/beading.h"     // Beading

namespace core {

// Sets the counts of central edges and the states of all, and splits edges where a transition ends.
// ENSURES: where two edges of one count meet, their states at the node are equal.
// COSTS: O(edges) for each of at most kCountPassesMax passes.
void decide_bead_counts(const Beading& beading, AxisGraph& graph);

inline constexpr int kCountPassesMax = 32;

}  // namespace core
