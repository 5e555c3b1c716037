// The roads of a spiral vase above its floor (walls/spiral_vase.h): the contour's perimeter, which
// rises through the layer as it goes round.
//
// A layer where the perimeter is one loop is one turn. Where a narrow place parts it into several
// loops, they are laid flat. There, and where a turn lies nowhere on the one below it, the turns
// below end flat:
//
//     ▁▁▁▂▂▂▃▃▃▃▃▃   the last turn: once round as it rises, once more at its top, with less and
//     ▁▁▂▂▂▃▃▃        less material
//     ▁▂▂▃▃▃          the first turn: more and more material
#pragma once

#include <vector>

#include "core/roads/road.h"         // Road
#include "core/settings.h"           // Settings
#include "core/walls/split_layer.h"  // SplitLayer

namespace core {

// COSTS: an offset of the slice, two of each neighbour, and some booleans.
// REQUIRES: in_vase(layer.slice); the style was applied (walls/wall_style.h); the slices from here
// on are single contours.
[[nodiscard]] std::vector<Road> vase_roads(const SplitLayer& layer, const Settings& settings);

}  // namespace core
