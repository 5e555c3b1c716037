// The part of a layer that roads cover: what is left of a region after them is still to be filled.
#pragma once

#include <vector>

#include "core/geometry.h"  // Ring
#include "core/region.h"    // Region
#include "core/road.h"      // Road
#include "core/units.h"     // Length

namespace core {

// Beads that bound a rest are taken to be wider than their spacing by this, so that rounding and
// the corners of curves leave no hairs between them; their round sides really reach farther.
inline constexpr Length kBeadSeam = Length::from_units(300);

// Adds the outlines of a road's pieces at `width`, mitred where it bends a little, with an octagon
// where it turns. They overlap; clean() unites them.
void add_bead_outlines(const Road& road, Length width, std::vector<Ring>& outlines);

// Everything within `width` / 2 of the roads, ends cut off square.
// COSTS: one boolean over four edges for each piece of road.
[[nodiscard]] Region bead_cover(const std::vector<Road>& roads, Length width);

}  // namespace core
