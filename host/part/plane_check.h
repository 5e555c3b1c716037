// Finds the planes of a mesh with open contours, before anything moves.
#pragma once

#include "core/result.h"              // Result
#include "core/slices/plane_sweep.h"  // PlaneSweep
#include "core/units.h"               // LayerIndex

namespace host {

struct OpenPlanes {
  core::LayerIndex layers = 0;  // with contours that can't be closed
  core::LayerIndex first = 0;   // the lowest of them, counted from 0
};

// Runs the sweep to its end. Errors: those of the sweep, and a stop signal.
// COSTS: about two thirds of the time for slicing.
[[nodiscard]] core::Result<OpenPlanes> check_planes(core::PlaneSweep& sweep);

}  // namespace host
