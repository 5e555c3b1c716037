// The state of the geometry just before a layer. From this and the slices around that layer, the
// rest of the print can be computed again, command for command, without the layers below.
#pragma once

#include <cstdint>
#include <memory>

#include "core/motions/motion_builder.h"   // MotionState
#include "core/roads/seams.h"              // SeamMemory
#include "core/settings.h"                 // Settings
#include "core/slices/slice.h"             // Slice
#include "core/units.h"                    // LayerIndex, Length
#include "host/gcode/file_place.h"         // FilePlace
#include "host/pipeline/motion_encoder.h"  // MotionEncoder

namespace host {

struct Checkpoint {
  core::LayerIndex layer = 0;  // the next layer, counted from 0
  core::Length bottom;         // of that layer
  std::int64_t commands = 0;   // of the print before that layer
  double filament_mm = 0;      // in roads below it
  core::MotionState motions;
  MotionEncoder::State encoder;
  core::SeamMemory seams;

  // Of a ready file: where in it reading goes on. All above but `layer`, `commands` and
  // `filament_mm` says nothing then. Null: a part.
  std::shared_ptr<const FilePlace> file = nullptr;
};

// Whether the slice is too far below the start to matter to any layer from there on: to walls, to
// the loose of the layer under them, or to what is laid at once for several layers.
[[nodiscard]] bool is_far_below(const core::Slice& slice, const Checkpoint& start,
                                const core::Settings& settings);

}  // namespace host
