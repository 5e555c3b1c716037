// Where a print stands just before a layer: with this, and the slices around that layer, the rest
// of the print can be computed once more, command for command, without what lies below.
#pragma once

#include <cstdint>

#include "core/motions/motion_builder.h"   // MotionState
#include "core/units.h"                    // LayerIndex, Length
#include "host/pipeline/motion_encoder.h"  // MotionEncoder

namespace host {

struct Checkpoint {
  core::LayerIndex layer = 0;  // the one that comes next, counted from 0
  core::Length bottom;         // of that layer
  std::int64_t commands = 0;   // of the print, before the layer's first
  double filament_mm = 0;      // in roads below it
  core::MotionState motions;
  MotionEncoder::State encoder;
};

}  // namespace host
