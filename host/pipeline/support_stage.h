// Supports for a print: what hangs is known only from above, so the part is sliced once into a
// temporary file, looked through from the top down, and then read again from there.
//
//     source ──> slices' spool ──(backwards)──> SupportFold ──> supports' spool
//                     │                                              │ (backwards)
//                     └──(forwards)──> the pipeline's layers <───────┘
//
// Both passes see the same slices, mended and compensated alike, because they are cut only once.
// The slices' spool also has what people have marked in them, for the fold alone.
// Memory: the fold's few layers and the buffers of two spools. The disk holds a slice and a support
// for each layer; equal neighbours take a few bytes.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "core/result.h"                  // Result, Status
#include "core/settings.h"                // Settings
#include "core/supports/bed_columns.h"    // BedColumns
#include "core/supports/support_fold.h"   // SupportFold, SupportLayer
#include "core/supports/support_roads.h"  // SupportPlanner
#include "core/walls/split_layer.h"       // SplitLayer
#include "host/part/layer_spool.h"        // LayerSpool
#include "host/pipeline/slice_intake.h"   // SliceIntake, TakenSlice
#include "host/system/warning_box.h"      // WarningBox

namespace host {

class SupportStage {
 public:
  using Stopped = std::function<bool()>;

  // `folder`: of the spools; empty: $TMPDIR, or /tmp. REQUIRES: the settings outlive the stage.
  SupportStage(const core::Settings& settings, std::string folder)
      : settings_(settings), folder_(std::move(folder)), planner_(settings) {}

  [[nodiscard]] bool wanted() const { return settings_.supports != core::SupportPlace::kOff; }

  // The temporary files. Errors: of the folder. REQUIRES: wanted(); called once.
  [[nodiscard]] core::Status make_spools(WarningBox& warnings);

  // Takes all of the part's slices, and finds where supports stand. Returns early when asked to
  // stop. Errors: of the intake, of the disk.
  // COSTS: slicing, which then is done, and the fold.
  // REQUIRES: the spools are made; called once, before the first slice was taken.
  [[nodiscard]] core::Status prepare(SliceIntake& intake, const Stopped& stopped);

  // What the intake gave, from the bed up. REQUIRES: prepared.
  [[nodiscard]] core::Result<TakenSlice> next_slice();

  // Gives the layer its supports, and those that hold it; returns the plan of their roads.
  // Errors: of the disk. REQUIRES: prepared; indices ascend.
  [[nodiscard]] core::Result<core::SupportPlanner::Reservation> reserve(core::SplitLayer& layer);
  void fill(core::SupportPlan& plan) const { planner_.fill(plan); }

  [[nodiscard]] std::int64_t spooled_bytes() const;
  // Processor time of the fold.
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  [[nodiscard]] core::Status spool_slices(SliceIntake& intake, const Stopped& stopped);
  [[nodiscard]] core::Status fold(const Stopped& stopped);
  [[nodiscard]] core::Status take_decided(core::SupportFold& fold);

  const core::Settings& settings_;
  std::string folder_;
  std::optional<LayerSpool> slices_, supports_;
  core::BedColumns columns_;
  std::deque<core::SupportLayer> recent_;  // the gap's, the latest last
  core::SupportPlanner planner_;
  double seconds_ = 0;
};

}  // namespace host
