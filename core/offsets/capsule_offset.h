// Offsets without a Voronoi diagram: slow, but right for any clean region.
//
// Everything nearer to a contour than the depth is a union of capsules, one about each edge; an
// inner offset is the region without them, an outer one the region with them.
#pragma once

#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

// The caps' arcs are replaced by chords within kCapsuleToleranceUnits.
// COSTS: O(points²) and worse when the depth exceeds the edges' lengths.
[[nodiscard]] Region capsule_offset(const Region& region, Length depth);

}  // namespace core
