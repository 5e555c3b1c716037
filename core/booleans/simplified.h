// A region with fewer points.
#pragma once

#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

// Its rings simplified (simplify.h) and what then crosses cleaned: the outlines of intersections
// and offsets have steps of a few units wherever their operands nearly agree. Left in, they cost a
// mountain its time and its soundness, and show nowhere.
// ENSURES: boundaries move by `tolerance` and a unit or two at most.
[[nodiscard]] Region simplified(const Region& region, Length tolerance);

}  // namespace core
