// What is done with a layer whose slice is not to be trusted: contours that stay open and had to be
// left out, or nothing at all while the part goes on above it.
//
//     repair      what could be closed is printed, the rest is missing there (segment_chains.h)
//     neighbour   the slice below is printed once more
//     pause       a print leaves the part before that layer and waits for its user, who lets it
//                 go on as repaired, or stops it; where nothing is printed, as stop (job.cpp)
//     stop        the print ends: nozzle lifted off the part, heaters off
//
// Each is told with its layer and height.
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

// As users write it; an unknown word is `repair`.
[[nodiscard]] std::string bad_layer_word(OnBadLayer action);
[[nodiscard]] OnBadLayer bad_layer_of(const std::string& word);

// Why the slice is bad; nothing: it is not. `more_above`: the part goes on.
[[nodiscard]] std::optional<std::string> why_bad(const core::SliceDefects& defects, bool empty,
                                                 bool more_above);

class BadLayers {
 public:
  // `part` stands in messages. REQUIRES: `warnings` outlives it.
  BadLayers(OnBadLayer action, std::string part, WarningBox& warnings)
      : action_(action), part_(std::move(part)), warnings_(warnings) {}

  // Takes the slices from the bed up; may change the slice. `layers` of the part, 0: not known.
  // ENSURES: a value is why the print is to pause before that layer.
  [[nodiscard]] core::Result<std::optional<std::string>> check(core::Slice& slice,
                                                               core::LayerIndex layers);

  [[nodiscard]] std::int64_t count() const { return count_; }

 private:
  OnBadLayer action_;
  std::string part_;
  WarningBox& warnings_;
  core::Region below_;  // kept for the neighbour only
  std::int64_t count_ = 0;
};

}  // namespace host
