// Runs: stretches of a contour whose offset elements cannot trim one another.
//
// Chains. Let consecutive edges have directions within less than 180° of one another, and at depth
// D let every edge keep a positive length between the crossings with its neighbours at convex
// corners:
//
//     length − D · tan(θ/2) at either end where the chain turns left  > 0
//
// Then at any depth 0 < d <= D no edge of the chain comes nearer than d to what neighbours leave of
// another's element. For: some axis has a positive component along all directions, so the chain,
// prolonged straight at both ends, is a graph over it, and so is its offset chain at every depth up
// to d (same directions, positive lengths). These graphs rise strictly with the depth, since all
// normals point upward. A point p of the chain at d whose nearest point of the (prolonged) base
// were at a distance d' < d would also lie on the chain at d': no two of the graphs share a point.
//
// Rings. A contour that turns right throughout is a convex obstacle: no edge trims another's
// element at any depth. One that turns left throughout, all its edges left positive at D, shrinks
// to convex polygons one inside the other: again only neighbours trim.
//
// So edges of one run are never tested against one another, at none of the depths.
#pragma once

#include "core/offsets/offset_input.h"  // OffsetInput

namespace core {

// Sets every edge's run. COSTS: O(n).
void find_runs(OffsetInput& contours, double deepest);

}  // namespace core
