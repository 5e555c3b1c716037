// Leaves out the points of a road that it doesn't need: each run of straight pieces between two
// arcs is simplified (simplify.h), then pieces that cut a corner go where the corner fits:
//
//     ──────╮ · ×       A small round corner is kept as a short piece between two longer ones (·).
//            ╲          The point × where those would meet, drawn on, stands for both of its ends,
//             │         if nothing of the way that it stands for is farther off than the tolerance.
#pragma once

#include <vector>

#include "core/geometry.h"         // Point
#include "core/motions/arc_fit.h"  // RoadPiece
#include "core/units.h"            // Length

namespace core {

// REQUIRES: the pieces start at `from`; tolerance >= 0.
// ENSURES: points left out are within the tolerance of the pieces that stand for them, and corners
// that are put in within the tolerance of the way that they stand for; laid_over_mm sums up as
// before, arcs stay; a larger tolerance never leaves more pieces of a run than 0 does.
// COSTS: O(n log n) on ordinary roads.
void simplify_pieces(Point from, std::vector<RoadPiece>& pieces, Length tolerance);

}  // namespace core
