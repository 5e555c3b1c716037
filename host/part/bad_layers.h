// How a layer with a bad slice is treated. A slice is bad if contours could not be closed and were
// left out, or if it is empty although the part continues above it.
//
//     repair      the closed contours are printed, the open ones are missing (segment_chains.h)
//     neighbour   the slice below is printed again instead
//     pause       the print pauses before that layer, off the part; the user resumes it (as
//                 repair) or stops it. Without a print, pause is stop (print_plan.cpp)
//     stop        the print ends: nozzle lifted off the part, heaters off
//
// Each bad layer is reported with its number and height.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/regions/region.h"      // Region
#include "core/result.h"              // Result
#include "core/slices/slice.h"        // Slice, SliceDefects
#include "core/units.h"               // LayerIndex
#include "host/system/warning_box.h"  // WarningBox

namespace host {

enum class OnBadLayer { kRepair, kNeighbour, kPause, kStop };

// The word of the option. An unknown word is `repair`.
[[nodiscard]] std::string bad_layer_word(OnBadLayer action);
[[nodiscard]] OnBadLayer bad_layer_of(const std::string& word);

// Why the slice is bad; nullopt if it is not. `more_above`: the part continues above it.
[[nodiscard]] std::optional<std::string> why_bad(const core::SliceDefects& defects, bool empty,
                                                 bool more_above);

class BadLayers {
 public:
  // `part` is for messages. REQUIRES: `warnings` outlives this.
  BadLayers(OnBadLayer action, std::string part, WarningBox& warnings)
      : action_(action), part_(std::move(part)), warnings_(warnings) {}

  // Checks the slices from the bed up, and may change one. `layers`: of the part, 0 if not known.
  // Returns why the print has to pause before this layer; nullopt if it has not.
  [[nodiscard]] core::Result<std::optional<std::string>> check(core::Slice& slice,
                                                               core::LayerIndex layers);

  [[nodiscard]] std::int64_t count() const { return count_; }

 private:
  OnBadLayer action_;
  std::string part_;
  WarningBox& warnings_;
  core::Region below_;  // only for kNeighbour
  std::int64_t count_ = 0;
};

}  // namespace host
