// Measures the wall in a vertical cut: how near the loose inside ever comes to the outside.
//
//     ▒▒▒▒▒▒▒▒▒          ░ loose, at its layer's mid-plane
//     ▒▒░░░░░▒▒▒╲ p      p ── q  the shortest way from it to what is not part: beside a slice, over
//     ▒▒░░░░░░░▒▒▒ q             or under one, beneath the bed, above the part
//
// In the cut's own plane, from slices and loose regions alone: independent of how the wall was
// found. The true distance in three dimensions can only be less, where the surface leans across
// the cut; in a plane of symmetry they are the same.
#pragma once

#include <optional>

#include "core/sections/layer_window.h"  // LayerWindow
#include "core/sections/section.h"       // SectionLine
#include "core/units.h"                  // Length

namespace core {

struct ThinnestWall {
  double thickness_mm = 0;
  // Along the line and above the bed: the loose point, and the point outside.
  Length loose_along, loose_height;
  Length outside_along, outside_height;
};

// The wall's thinnest place in window.layer(), nothing where it has no loose region on the line.
// Only what lies within reach of the wall, and the bed, is looked at: the part's end is not.
// COSTS: O(points of the window's slices), and the product of intervals.
[[nodiscard]] std::optional<ThinnestWall> thinnest_wall(const LayerWindow& window,
                                                        const SectionLine& line);

}  // namespace core
