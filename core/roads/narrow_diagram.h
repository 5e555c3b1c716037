// The part of the Voronoi diagram that narrow gaps need: the primary edges inside a region, up to
// a clearance.
//
// Site by site, the border of its cell is the lowest of a few curves, those of the sites near it
// (cell_curves.h, lower_envelope.h). Each border between two cells is found from both sides, and
// taken from the one with the lower number. The pieces are linked where their ends meet. Then
// every end meets another one, or lies in a corner of the contour, or where the clearance was cut
// off. Anything else means that rounding has decided a near tie in two ways: a border was seen from
// the higher number only, or two ends missed one another by a little. Where these are few they are
// joined; otherwise there is no answer.
//
// It costs a tenth of the whole diagram (voronoi_diagram.h) where a few sites are near one another.
// The whole one is used where this has no answer.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry.h"                 // Ring
#include "core/offsets/voronoi_diagram.h"  // VoronoiDiagram

namespace core {

// Vertices nearer to one another than 4 units in x and y are one: coordinates and heights are true
// to 10 units. Edges end at vertices of height `clearance_max` where the region is wider. Each edge
// has its start, its site and its twin's; cells are not linked. nullopt: contours touch, there is
// a near tie, or very many sites are near one another; ask for the whole diagram.
// REQUIRES: a clean region's rings; clearance_max > 0, units.
// COSTS: O(n · k²) with k sites within twice the clearance of a site, and at most as much as the
// whole diagram.
[[nodiscard]] std::optional<VoronoiDiagram> make_narrow_diagram(const std::vector<Ring>& rings,
                                                                double clearance_max);

}  // namespace core
