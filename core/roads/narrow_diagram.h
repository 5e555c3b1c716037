// The part of the Voronoi diagram that narrow gaps are about: the primary edges inside a region, up
// to a clearance.
//
// Site by site, its cell's border is the lowest of a few curves (cell_curves.h, lower_envelope.h),
// those of the sites near it. Each border between two cells is found from both sides and taken from
// the one with the lower number; the pieces are linked where their ends meet. Then every end has
// company, or lies in a corner of the contour, or where the clearance was cut off: anything else
// means that rounding has decided a near tie in two ways, and there is no answer.
//
// Costs a tenth of the whole diagram (voronoi_diagram.h), which stays for what this can't do.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry.h"                 // Ring
#include "core/offsets/voronoi_diagram.h"  // VoronoiDiagram

namespace core {

// Vertices nearer to one another than 4 units in x and y are one: places and heights are true to 10
// units. Edges end at vertices of height `clearance_max` where the region is wider. Of each edge,
// its site and its twin's are set, and where it begins; cells are not linked. nullopt: contours
// touch, or a near tie; ask for the whole diagram. REQUIRES: a clean region's rings; clearance_max
// > 0, units. COSTS: O(n · k²) at worst, with k sites within twice the clearance of a site.
[[nodiscard]] std::optional<VoronoiDiagram> make_narrow_diagram(const std::vector<Ring>& rings,
                                                                double clearance_max);

}  // namespace core
