// Makes of the inside what can be printed as an inside.
//
// The splitter's loose region can have tongues narrower than any loose road and crumbs smaller than
// one: printed loosely they would be nearly empty, with the wall around them hanging in the air.
// They become solid. Nothing ever goes the other way: the wall is never thinned.
//
//     loose ──open by width_min──> what is wide enough
//       └── minus that: tongues and crumbs -> solid; the bits that opening cuts off a sharp corner
//           stay loose (they lie beside a wide place, and a wall that grew there could not be
//           filled)
#pragma once

#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

struct RegulariseOptions {
  Length width_min;         // REQUIRES: >= 0; 0 leaves narrow places as they are
  double area_min_mm2 = 0;  // REQUIRES: >= 0; smaller islands become solid
  Length arc_tolerance;     // REQUIRES: > 0
};

// The part of `loose` that stays loose.
// ENSURES: a subset of `loose`, to 2 units (boolean.h).
// COSTS: a mountain of `loose` where no place is narrow, else two and three region operations.
[[nodiscard]] Region regularise_loose(const Region& loose, const RegulariseOptions& options);

}  // namespace core
