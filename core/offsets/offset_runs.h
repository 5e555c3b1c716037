// Runs: stretches of a contour whose offset elements cannot trim one another. Edges of one run are
// never tested against one another, at none of the depths.
//
// Chains. Consider consecutive edges whose directions lie within less than 180° of one another.
// Let every edge keep a positive length at depth D between its crossings with the neighbours at
// convex corners:
//
//     length − D · tan(θ/2) at either end where the chain turns left  > 0
//
// Then at any depth 0 < d <= D no edge of the chain comes nearer than d to what the neighbours
// leave of another edge's element. Proof: some axis has a positive component along all directions,
// so the chain, prolonged straight at both ends, is a graph over that axis. So is its offset chain
// at every depth up to d, with the same directions and positive lengths. These graphs rise
// strictly with the depth, because all normals point upward. Now let p be a point of the chain at
// d whose nearest point of the (prolonged) base is at a distance d' < d. Then p also lies on the
// chain at d', but no two of the graphs share a point.
//
// Rings. A contour that turns right throughout is a convex obstacle: no edge trims another's
// element at any depth. A contour that turns left throughout, with all its edges positive at D,
// shrinks to convex polygons one inside the other: again only neighbours trim.
#pragma once

#include "core/offsets/offset_input.h"  // OffsetInput

namespace core {

// Sets every edge's run. COSTS: O(n).
void find_runs(OffsetInput& contours, double deepest);

}  // namespace core
