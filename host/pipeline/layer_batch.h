// One slice's work on its way through the stages (ordered_stages.h): the slice, its offsets, and
// the layers that the window can split once this slice is known.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/offsets/slice_offsets.h"   // OffsetCutter
#include "core/result.h"                  // Error
#include "core/roads/layer_planner.h"     // LayerPlanner
#include "core/roads/seams.h"             // SeamMemory
#include "core/slices/slice.h"            // Slice
#include "core/supports/support_fold.h"   // SupportLayer
#include "core/supports/support_roads.h"  // SupportPlanner
#include "core/units.h"                   // LayerIndex, Length
#include "host/pipeline/laid_roads.h"     // LaidRoads
#include "host/pipeline/stage_meter.h"    // StageUse

namespace host {

struct SettledLayer {
  core::LayerIndex index = 0;
  core::Length bottom;
  core::LayerPlanner::Reservation reserved;
  std::shared_ptr<const core::SeamMemory> seams_before;  // of the layers below
  core::LayerPlanner::Ordering ordering;
  std::shared_ptr<LaidRoads> laid;
  core::SplitLayer layer;            // as it is given out
  std::optional<std::string> pause;  // why to pause before it
  core::SupportPlanner::Reservation support;
};

struct LayerBatch {
  std::optional<core::Slice> slice;  // nullopt: the source has ended, the window is emptied
  std::optional<core::Error> error;  // why there is no slice
  std::optional<std::string> pause;  // why to pause before its layer
  // Its supports, if they are known as soon; with them those of slices below it that were left out.
  std::deque<core::SupportLayer> supports;
  core::OffsetCutter::Reservation offsets;
  std::int64_t offset_retries = 0;
  std::vector<SettledLayer> settled;
  StageUse use;
  double watched_s = 0;  // time in the stages that layer_watch.h watches
};

}  // namespace host
