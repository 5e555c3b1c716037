// The part of a layer that roads cover: what is left of a region after them is still to be filled.
#pragma once

#include <vector>

#include "core/geometry.h"        // Ring
#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/units.h"           // Length

namespace core {

// Beads that bound a rest are taken to be wider than their spacing by this, so that rounding and
// the corners of curves leave no hairs between them; their round sides really reach farther.
inline constexpr Length kBeadSeam = Length::from_units(300);

// Adds the outline of a road at `width`: mitred where it bends a little, round (to 45°) outside
// where it turns, ends cut off square. ENSURES: winding numbers of 0 and more; covered is what has
// 1 or more. The outline crosses itself where the road does, and on the inner side of sharp turns.
void add_bead_outlines(const Road& road, Length width, std::vector<Ring>& outlines);

// What of the region is farther than `width` / 2 from the roads.
// COSTS: one boolean over two edges for each piece of road and some for each sharp turn.
[[nodiscard]] Region uncovered(const Region& region, const std::vector<Road>& roads, Length width);

}  // namespace core
