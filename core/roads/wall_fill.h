// Fills the wall, without a void and without laying more than it holds.
//
//     wide parts     parallel roads at the fill angle, joined at their ends (line_fill.h)
//     bands          where at most five roads fit side by side: roads along the edges, where short
//                    rows would lay far too much in their joins
//     rests          what both leave: roads of their own width (gap_fill.h)
//
// Joins lay material that the rows they connect have laid already, and rows that end before the
// edge lay too little there. With s the volume-true distance, c the depth at which rows end, b the
// mean breadth of a piece and p the rows' distance, both cancel when
//
//     p = s (1 + (p − 2c) / b)
//
// so that a narrow piece gets rows a little farther apart (never so far that beads don't touch),
// and what then is missing or too much is made up by the roads' width: what is laid is what the
// piece holds.
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings
#include "core/units.h"           // LayerIndex, Length

namespace core {

// COSTS: cuts of the foot of each piece's mountain, a boolean with the outlines of its roads, and a
// medial axis of each rest.
[[nodiscard]] std::vector<Road> wall_roads(const Region& wall, LayerIndex layer, Length height,
                                           const Settings& settings);

}  // namespace core
