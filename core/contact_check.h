// A cheap exact answer to "is this clean already?", so that the costly way is taken only when it
// must be.
//
// Edges are laid into a uniform grid of about one cell an edge, and tested against the others in
// their cells with exact integer products. Two edges may meet only in the corner they share.
#pragma once

#include <vector>

#include "core/geometry.h"  // Ring

namespace core {

// True: from_clean_rings(rings) holds. False: not known; rings that merely touch give false too.
// REQUIRES: coordinates within ±kCoordinateMax.
// COSTS: O(points) on contours, O(points²) when most edges lie in one heap.
[[nodiscard]] bool surely_clean(const std::vector<Ring>& rings);

// The rings, with a corner added wherever another's corner lies within an edge.
// REQUIRES: clean rings. COSTS: as surely_clean().
[[nodiscard]] std::vector<Ring> split_at_touches(const std::vector<Ring>& rings);

}  // namespace core
