// The area that roads cover. What is left of a region without it is still to be filled.
#pragma once

#include <vector>

#include "core/geometry.h"        // Ring
#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/units.h"           // Length

namespace core {

// Beads that bound a gap are taken to be wider than their spacing by this, so that rounding and
// the corners of curves leave no hairs between them. Their round sides really reach farther.
inline constexpr Length kBeadSeam = Length::from_units(300);

// Adds the outline of a road at `width`: mitred where it bends a little, round (to 45°) outside
// where it turns, with square ends. ENSURES: winding numbers of 0 and more; an area with 1 or more
// is covered. The outline crosses itself where the road does, and inside sharp turns.
void add_bead_outlines(const Road& road, Length width, std::vector<Ring>& outlines);

// What of the region is farther than `width` / 2 from the roads.
// COSTS: one boolean over two edges for each piece of road and some for each sharp turn.
[[nodiscard]] Region uncovered(const Region& region, const std::vector<Road>& roads, Length width);

}  // namespace core
