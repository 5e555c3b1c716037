// A region with fewer points.
#pragma once

#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

// The rings simplified (simplify.h), and what crosses then cleaned. The outlines of intersections
// and offsets have steps of a few units wherever their operands nearly agree. Such steps would make
// a Voronoi diagram slow and unsound, and show nowhere in the print.
// ENSURES: boundaries move by `tolerance` and a unit or two at most.
[[nodiscard]] Region simplified(const Region& region, Length tolerance);

}  // namespace core
