// Whether contours keep clear of themselves and of one another, exactly and fast.
//
// Contours are cut into chains of at most 16 edges that go one way in x and one way in y. A chain
// cannot meet itself. Two chains can meet only where their boxes overlap, and those of one smooth
// contour overlap only at their common corner. The boxes are compared eight at a time
// (box_tree.h). Where there are several rings, the winding number about the lowest corner of each
// is counted.
#pragma once

#include <vector>

#include "core/geometry.h"  // Ring

namespace core {

// True when edges meet in nothing but the corner they share, outer contours turn counter-clockwise
// and stand outside all others or in a hole, and holes the other way: the rings are clean.
// False otherwise, also for rings that touch and may be clean all the same.
// REQUIRES: coordinates within ±kCoordinateMax.
// COSTS: O(n log n + pairs of chains with overlapping boxes + rings · chains at their height);
// O(n²) when most edges lie in one heap.
[[nodiscard]] bool keep_clear(const std::vector<Ring>& rings);

}  // namespace core
