// Bead lines as roads: on the grid, with widths, without the points that they don't need.
#pragma once

#include <vector>

#include "core/roads/bead_lines.h"  // BeadLine
#include "core/roads/beading.h"     // Beading
#include "core/roads/road.h"        // Road
#include "core/units.h"             // Length

namespace core {

// How far the width between two points may be from what the place holds.
inline constexpr Length kBeadWidthTolerance = Length::from_units(100);

// Adds the line as a road, unless nothing worth a road is left of it. Points that are left out lie
// within `tolerance` of the road, and their widths within kBeadWidthTolerance of its widths.
// COSTS: as simplify() in simplify.h.
void add_bead_road(const BeadLine& line, const Beading& beading, RoadKind kind, Length tolerance,
                   std::vector<Road>& roads);

}  // namespace core
