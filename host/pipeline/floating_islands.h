// Islands that begin in the air, as they are met: the first ones are told, or the print ends before
// the layer.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "core/result.h"                // Status
#include "core/roads/hanging_places.h"  // HangingPlaces
#include "core/slices/slice.h"          // Slice
#include "host/pipeline/hanging_log.h"  // OnFloating
#include "host/system/warning_box.h"    // WarningBox

namespace host {

class FloatingIslands {
 public:
  // `part` is for messages. REQUIRES: `warnings` outlives this.
  FloatingIslands(OnFloating action, std::string part, WarningBox& warnings)
      : action_(action), part_(std::move(part)), warnings_(warnings) {}

  // Warns of the first kHangingTold. Error if the print is to end before this layer.
  [[nodiscard]] core::Status check(const core::Slice& slice, const core::HangingPlaces& hanging);

 private:
  OnFloating action_;
  std::string part_;
  WarningBox& warnings_;
  std::size_t told_ = 0;
};

}  // namespace host
