// Whether rings are clean already: a cheap exact answer, which spares most of them the costly
// cleaning.
//
// Two edges may meet only in the corner they share (clear_contours.h). Where contours may touch,
// edges are entered in a uniform grid of about one cell an edge. All products are of integers, so
// all is exact.
#pragma once

#include <vector>

#include "core/geometry.h"  // Ring

namespace core {

// True: the rings meet what from_clean_rings() requires. False: not known; rings that merely touch
// give false, too.
// REQUIRES: coordinates within ±kCoordinateMax.
// COSTS: as keep_clear() in clear_contours.h.
[[nodiscard]] bool surely_clean(const std::vector<Ring>& rings);

// The rings, with a corner added wherever another's corner lies within an edge.
// REQUIRES: clean rings. COSTS: O(points) on contours, O(points²) when most edges lie
// in one heap.
[[nodiscard]] std::vector<Ring> split_at_touches(const std::vector<Ring>& rings);

}  // namespace core
