// Gap fill: fills the gaps that whole roads leave with roads of fitting width, so that the wall is
// dense.
//
//     ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒      The gap's medial axis is the centre line. Twice its distance to the
//     ────┈┈┈┈════════      gap's boundary is the gap's width. A line is one road, which changes
//     ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒      its width along its way.
//
// Keywords: thin walls, variable extrusion width, medial axis.
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings
#include "core/units.h"           // Length

namespace core {

// Narrower gaps get no road.
[[nodiscard]] Length gap_width_min(const Settings& settings);

// `seam`: the gaps were made so much narrower than what they are, on both sides together.
// COSTS: a medial axis of the gaps. Crumbs too small for any road are sorted out before.
[[nodiscard]] std::vector<Road> gap_fill_roads(const Region& gaps, Length seam, Length layer_height,
                                               const Settings& settings);

}  // namespace core
