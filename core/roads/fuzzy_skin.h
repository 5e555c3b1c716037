// A rough surface: outer perimeters whose points are moved in and out by chance.
//
//     ───────────────   ──>   ╱╲_╱╲╱▔╲__╱╲_   points about fuzzy_skin_point_distance apart (¾ to
//                                             1¼ of it), each moved across the road by at most
//                                             fuzzy_skin_thickness, in or out
//
// Chance is a hash of a point's place and layer: threads and order decide nothing. The method and
// its two numbers are PrusaSlicer's. The first layer stays as it is.
#pragma once

#include <vector>

#include "core/roads/road.h"  // Road
#include "core/settings.h"    // Settings
#include "core/units.h"       // LayerIndex

namespace core {

// Makes those of a layer's roads rough that the settings ask for: outer perimeters, open ones too;
// of closed ones those around the part (counter-clockwise), or holes as well.
// ENSURES: each road starts within fuzzy_skin_thickness of where it did; a new point keeps the
// width and the hold of the place that it was moved from. COSTS: O(points).
void make_fuzzy(std::vector<Road>& roads, LayerIndex layer, const Settings& settings);

}  // namespace core
