// Slices with their supports, of a part that is built while it is still read: support_lookahead
// layers are known above each (core/supports/support_lookahead.h). No temporary file is needed.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/regions/region.h"              // Region
#include "core/result.h"                      // Result, Status
#include "core/settings.h"                    // Settings
#include "core/slices/slice.h"                // SliceDefects
#include "core/supports/support_lookahead.h"  // SupportLookahead
#include "host/pipeline/slice_intake.h"       // SliceIntake, TakenSlice
#include "host/system/warning_box.h"          // WarningBox

namespace host {

class SupportAhead {
 public:
  // REQUIRES: support_lookahead > 0; the settings outlive it.
  explicit SupportAhead(const core::Settings& settings)
      : settings_(settings), lookahead_(settings) {}

  // The next slice up with its supports. Ends early when asked to stop. Warns of what can't be
  // held. Errors: of the intake.
  // COSTS: takes slices until the layer's block is decided; holds those of two blocks.
  [[nodiscard]] core::Result<TakenSlice> next(SliceIntake& intake,
                                              const std::function<bool()>& stopped,
                                              WarningBox& warnings);

  // Processor time of the fold.
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  // A slice, but for its region, which the fold shares.
  struct Held {
    TakenSlice taken;
    std::shared_ptr<const core::Region> region;
  };

  [[nodiscard]] core::Status take(SliceIntake& intake);
  void push(const Held& held);

  const core::Settings& settings_;
  core::SupportLookahead lookahead_;
  std::deque<Held> held_;
  bool ended_ = false;
  double seconds_ = 0;
};

}  // namespace host
