// Makes the inside printable: what is too narrow or too small for loose roads becomes solid.
//
// The splitter's loose region can have tongues narrower than any loose road, and crumbs smaller
// than one. Filled loosely, they would be nearly empty, and the wall around them would hang in the
// air. Loose becomes solid, never the other way: the wall is not thinned anywhere.
//
//     loose ──opened by width_min──> what is wide enough
//       └── the difference: tongues and crumbs become solid. What opening cuts off a sharp corner
//           stays loose: it lies beside a wide part, and a wall that grew there could not be
//           filled.
//
// Keywords: morphological opening, minimum infill area, narrow infill.
#pragma once

#include "core/regions/region.h"  // Region
#include "core/settings.h"        // Settings
#include "core/units.h"           // Length

namespace core {

struct RegulariseOptions {
  Length width_min;         // REQUIRES: >= 0; 0 leaves narrow places as they are
  double area_min_mm2 = 0;  // REQUIRES: >= 0; smaller islands become solid
  Length arc_tolerance;     // REQUIRES: > 0
};

[[nodiscard]] RegulariseOptions regularise_options(const Settings& settings);

// The part of `loose` that stays loose.
// ENSURES: a subset of `loose`, to 2 units (boolean.h).
// COSTS: one offset of `loose` where nothing is narrow, else two and three region operations.
[[nodiscard]] Region regularise_loose(const Region& loose, const RegulariseOptions& options);

}  // namespace core
