// Parts of a line that are near a deeper core: closed roads where all of it is, else open ones.
//
//     ──────────────────╮                 line: kept where the core is near,
//     ┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄ ╰──────────────   cut open where it is not
//       ╭─ core ─────╮      too narrow
//     ┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄ ╭──────────────
//     ──────────────────╯
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/units.h"           // Length

namespace core {

// The parts of a centre line within `reach` of its core: closed roads where all of it is, open
// ones elsewhere. Pieces shorter than the road is wide stay as their neighbours are. Points that
// they don't need for `tolerance` are left out.
// COSTS: O(points).
[[nodiscard]] std::vector<Road> roads_near_core(const Region& line, const Region& core,
                                                Length reach, Length width, RoadKind kind,
                                                Length tolerance);

}  // namespace core
