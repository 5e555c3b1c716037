// Supports for a print: what hangs is known only from above, so the part is sliced once into a
// temporary file, looked through from the top down, and then read again from there.
//
//     source ──> slices' spool ──(backwards)──> SupportFold ──> supports' spool
//                (TreeReach)                    or TreeFold
//                     │                                              │ (backwards)
//                     └──(forwards)──> the pipeline's layers <───────┘
//
// Both passes see the same slices, mended and compensated alike, because they are cut only once.
// The slices' spool also has what people have marked in them, for the fold alone.
// With support_lookahead, none of this: supports come with the slices (support_ahead.h).
//
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
#include "core/supports/tree_standing.h"  // TreeStanding
#include "core/walls/split_layer.h"       // SplitLayer
#include "host/part/layer_spool.h"        // LayerSpool
#include "host/pipeline/layer_watch.h"    // LayerWatch
#include "host/pipeline/preparation.h"    // PreparationBox
#include "host/pipeline/slice_intake.h"   // SliceIntake, TakenSlice
#include "host/pipeline/support_ahead.h"  // SupportAhead
#include "host/system/warning_box.h"      // WarningBox

namespace host {

class SupportStage {
 public:
  using Stopped = std::function<bool()>;

  // `folder`: of the spools; empty: $TMPDIR, or /tmp. `stopped`: whether to end early.
  // REQUIRES: the settings outlive the stage.
  SupportStage(const core::Settings& settings, std::string folder, Stopped stopped)
      : settings_(settings),
        folder_(std::move(folder)),
        stopped_(std::move(stopped)),
        wanted_(settings.supports != core::SupportPlace::kOff),
        planner_(settings) {
    if (wanted() && settings.support_lookahead > 0) ahead_.emplace(settings);
  }

  [[nodiscard]] bool wanted() const { return wanted_; }
  // Whether all of the part is needed before its first layer.
  [[nodiscard]] bool wants_all() const { return wanted() && !ahead_; }

  // The temporary files. Errors: of the folder. REQUIRES: wants_all(); called once.
  [[nodiscard]] core::Status make_spools(WarningBox& warnings);

  // Nothing hangs: none are wanted any more. REQUIRES: before the first slice.
  void call_off() {
    wanted_ = false;
    slices_.reset();
    supports_.reset();
    ahead_.reset();
  }

  // Takes all of the part's slices, and finds where supports stand; tells of each layer, and has
  // `watch` see those that take long. Returns early when asked to stop. Errors: of the intake, of
  // the disk.
  // COSTS: slicing, which then is done, and the fold.
  // REQUIRES: the spools are made; called once, before the first slice was taken.
  [[nodiscard]] core::Status prepare(SliceIntake& intake, PreparationBox& told, LayerWatch& watch);

  // The next slice up. Errors: of the intake, of the disk. REQUIRES: prepared, if all of the part
  // is needed.
  [[nodiscard]] core::Result<TakenSlice> next_slice(SliceIntake& intake, WarningBox& warnings);

  // Puts the supports that came with a slice to those of slices below it, as far as they are of use
  // for the layers above them.
  void keep(std::optional<core::SupportLayer>& support,
            std::deque<core::SupportLayer>& supports) const;
  // The supports that came with slices, from the bed up. REQUIRES: before they are reserved.
  void see(std::deque<core::SupportLayer> supports);

  // Gives the layer its supports, and those that hold it; returns the plan of their roads.
  // Errors: of the disk. REQUIRES: prepared, or its supports seen; indices ascend.
  [[nodiscard]] core::Result<core::SupportPlanner::Reservation> reserve(core::SplitLayer& layer);
  void fill(core::SupportPlan& plan) const { planner_.fill(plan); }

  [[nodiscard]] std::int64_t spooled_bytes() const;
  // Processor time of the fold; of its worst layer, 0 with support_lookahead.
  [[nodiscard]] double seconds() const { return ahead_ ? ahead_->seconds() : seconds_; }
  [[nodiscard]] double worst_layer_s() const { return worst_layer_s_; }

 private:
  [[nodiscard]] core::Status spool_slices(SliceIntake& intake, PreparationBox& told);
  template <typename Fold, typename Push>
  [[nodiscard]] core::Status fold_down(Fold& fold, const Push& push, core::LayerIndex layers,
                                       PreparationBox& told, LayerWatch& watch);
  [[nodiscard]] core::Status fold(core::LayerIndex layers, PreparationBox& told, LayerWatch& watch);
  template <typename Fold>  // SupportFold, TreeFold
  [[nodiscard]] core::Status take_decided(Fold& fold);
  [[nodiscard]] bool trees() const { return settings_.support_style == core::SupportStyle::kTree; }
  [[nodiscard]] core::Result<core::SupportLayer> next_support();
  // So many layers of supports are of use for the layer above them.
  [[nodiscard]] std::size_t layers_kept() const {
    return static_cast<std::size_t>(settings_.support_top_gap_layers) + 2;
  }

  const core::Settings& settings_;
  std::string folder_;
  Stopped stopped_;
  bool wanted_;
  std::optional<LayerSpool> slices_, supports_;
  std::optional<SupportAhead> ahead_;
  std::deque<core::SupportLayer> seen_;
  core::BedColumns columns_;
  core::TreeStanding standing_;
  std::deque<core::SupportLayer> recent_;  // the gap's, the latest last
  core::SupportPlanner planner_;
  double seconds_ = 0, worst_layer_s_ = 0;
};

}  // namespace host
