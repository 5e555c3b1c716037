// Polygon offset without a Voronoi diagram: slow, but right for any clean region. The last resort
// of voronoi_mountain.h.
//
// All points nearer to a contour than the depth form a union of capsules, one around each edge (a
// Minkowski sum of the contour and a disc). An inner offset is the region without them, an outer
// offset the region with them.
#pragma once

#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

// The caps' arcs are replaced by chords within kCapsuleToleranceUnits.
// COSTS: O(points²) and worse when the depth exceeds the edges' lengths.
[[nodiscard]] Region capsule_offset(const Region& region, Length depth);

}  // namespace core
