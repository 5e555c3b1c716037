// Whether a Voronoi diagram is right: Boost.Polygon's are not always (boostorg/polygon#43).
//
// Checked: every edge of the contours has a cell that runs through both its ends; cells close and
// twins agree; every vertex is as far from each of its sites as from the others, and no nearer to
// the sites of the vertices next to it; no edge crosses a contour. A diagram that is right at all
// these points is right everywhere, as a triangulation that is locally Delaunay is Delaunay.
#pragma once

#include <vector>

#include "core/offsets/voronoi_diagram.h"  // VoronoiDiagram

namespace core {

// Sets the vertices' heights. Returns false when any check fails.
// COSTS: O(edges).
[[nodiscard]] bool measure_and_check(const std::vector<Ring>& rings, VoronoiDiagram& diagram);

}  // namespace core
