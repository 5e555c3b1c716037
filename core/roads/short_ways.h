// Short ways between two roads of the fill, laid instead of travelled:
//
//     ══════════╗ ← a road ends        The nozzle is there all the same. What it lays on the way is
//               ║                      a road of the least width, so that it neither stops nor
//     ═════▶ ╶──╨═══════ the next      pulls the filament back for a hair's breadth.
//
// A way is laid from one road of the fill to the next, where it is short, crosses no perimeter and
// keeps half its width from the slice's contour. Tops, bridges over air, and roads that are thicker
// than the layer are left alone.
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings
#include "core/units.h"           // Length

namespace core {

// The longest way that is laid.
inline constexpr Length kShortWayMax = Length::from_units(15'000);

// Puts the ways between the roads, as gap fill.
// REQUIRES: the roads are in the order of printing.
// COSTS: O(roads); where there are short ways, O(points) and the edges near to each.
void lay_short_ways(const Region& slice, const Settings& settings, std::vector<Road>& roads);

}  // namespace core
