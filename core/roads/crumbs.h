// Crumbs: what gap fill lays by itself, that holds next to nothing, and that nobody would see.
//
//     ═══════════ ▪ ══════════     The nozzle travels to it and away again, for less than two
//                 ↑                squares of a road.
//
// A crumb is a run of gap fill that no other road leads to, away from the slice's contour, under
// the layer above and over the layer below.
#pragma once

#include <vector>

#include "core/roads/road.h"         // Road
#include "core/settings.h"           // Settings
#include "core/walls/split_layer.h"  // SplitLayer

namespace core {

// A run that covers fewer squares of a road is a crumb.
inline constexpr double kCrumbSquaresMax = 2;

// Takes the crumbs out.
// REQUIRES: the roads are in the order of printing, with the short ways between them.
// COSTS: O(roads); where there are runs as small, O(points of the slices).
void drop_crumbs(const SplitLayer& layer, const Settings& settings, std::vector<Road>& roads);

}  // namespace core
