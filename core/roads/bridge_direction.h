// In which direction a bridge is laid.
//
// Tried are the directions of the area's edges, the most common first, those across them, and some
// fixed ones. For each, rows are laid and their stretches in the air measured exactly. The best
// leaves least length that is held on one side only, and then has the shortest spans: least sum of
// their squares, which is the mean span where all rows together are of one length.
#pragma once

#include "core/roads/bridge_rows.h"  // BridgeArea
#include "core/units.h"              // Length
#include "core/vector.h"             // Vector

namespace core {

struct DirectionTrials {
  int edges = 0;  // each with the one across it
  int fixed = 0;  // evenly over half a turn
};

// Of length 1. Among equally good ones the first that was tried.
// COSTS: O(edges of the area), and for each direction that is tried as bridge_rows() with 48 rows.
[[nodiscard]] Vector best_direction(const BridgeArea& area, Length distance,
                                    const DirectionTrials& trials);

}  // namespace core
