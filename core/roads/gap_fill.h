// Fills what whole roads leave with roads of their own width, so that the wall is dense.
//
//     ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒      the rest's medial axis is the centre line, twice its distance to the
//     ────┈┈┈┈════════      rest's boundary the room; a line is cut into roads of one width each
//     ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒      where the room changes by more than kWidthStep
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings
#include "core/units.h"           // Length

namespace core {

// How beads lie against what bounds the rest.
enum class GapEdges {
  kRoads,  // other roads: the bead's round sides reach into the gaps that theirs leave
  kPart,   // the part's own contour: the bead does not reach beyond it
};

// Widths of one road differ from the room it has by at most about half this share.
inline constexpr double kWidthStep = 0.2;

// What the grid and its roundings may take from a wall that is as wide as the narrowest road.
inline constexpr Length kRoomSlack = Length::from_units(10);

// Narrower room gets no road.
[[nodiscard]] Length rest_room_min(const Settings& settings, GapEdges edges);

// COSTS: a medial axis of the rest; crumbs too small for any road are sorted out before.
[[nodiscard]] std::vector<Road> gap_fill_roads(const Region& rest, GapEdges edges,
                                               Length layer_height, const Settings& settings);

}  // namespace core
