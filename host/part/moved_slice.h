// What a slice is made of, moved across the bed.
#pragma once

#include "core/geometry.h"          // Box
#include "core/regions/region.h"    // Region
#include "core/slices/slice.h"      // Slice
#include "host/part/bed_placing.h"  // Shift

namespace host {

// REQUIRES: what comes out lies within ±kCoordinateMax.
[[nodiscard]] core::Region moved(const core::Region& region, const Shift& shift);

// What of it is within a box. COSTS: a boolean operation, if not all of it is.
[[nodiscard]] core::Region clipped(const core::Region& region, const core::Box& box);

// Where they are told to be.
[[nodiscard]] core::SliceDefects moved(core::SliceDefects defects, const Shift& shift);

}  // namespace host
