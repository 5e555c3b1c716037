// A look at all planes of a mesh before anything moves: at which of them do contours stay open?
#pragma once

#include "core/result.h"              // Result
#include "core/slices/plane_sweep.h"  // PlaneSweep
#include "core/units.h"               // LayerIndex

namespace host {

struct OpenPlanes {
  core::LayerIndex layers = 0;  // with contours that can't be closed
  core::LayerIndex first = 0;   // the lowest of them, counted from 0
};

// To the sweep's end. Errors are the sweep's; and a stop signal is one.
// COSTS: about two thirds of slicing, nothing of offsets and roads.
[[nodiscard]] core::Result<OpenPlanes> check_planes(core::PlaneSweep& sweep);

}  // namespace host
