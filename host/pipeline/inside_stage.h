// An inside that holds up its own roof: what a layer's inside needs is known only from above, so
// all insides are found before the first road, into a temporary file, looked through from the top
// down, and then read again from there.
//
//     source ─> OffsetCutter ═> WallSplitter ──> slices, insides
//                                                         │ (backwards)
//     slices ──(forwards)──> the pipeline's layers        ▼
//                                 ▲                RoofFold, LightningFold ──> insides, branches
//                                 └──(forwards)───────────────────┘
//
// The window runs in this pass, so the pipeline's own has no window: the layer's wall is its slice
// without the inside. Memory: that of the window and of the batches under way in this pass, then
// the fold's few layers, then the buffers of the spools. The disk holds a slice and two insides for
// each layer; equal neighbours take a few bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/offsets/layer_offsets.h"    // Layer
#include "core/result.h"                   // Result, Status
#include "core/settings.h"                 // Settings
#include "core/supports/lightning_fold.h"  // LightningFold
#include "core/supports/roof_fold.h"       // RoofFold
#include "core/walls/branch.h"             // Branches
#include "core/walls/split_layer.h"        // SplitLayer
#include "core/walls/wall_splitter.h"      // WallSplitter
#include "host/files/record_spool.h"       // RecordSpool
#include "host/part/layer_spool.h"         // LayerSpool
#include "host/pipeline/preparation.h"     // PreparationBox
#include "host/pipeline/slice_intake.h"    // TakenSlice
#include "host/pipeline/stage_meter.h"     // StageUse
#include "host/system/warning_box.h"       // WarningBox

namespace host {

// Whether the settings ask for it.
[[nodiscard]] bool holds_its_roof(const core::Settings& settings);

class InsideStage {
 public:
  using Source = std::function<core::Result<TakenSlice>()>;
  using Stopped = std::function<bool()>;
  // Where progress is told, and the number of the part's layers; 0: not known.
  struct Told {
    PreparationBox& box;
    core::LayerIndex layers = 0;
  };

  // `folder`: of the spools; empty: $TMPDIR, or /tmp. REQUIRES: the settings outlive the stage.
  InsideStage(const core::Settings& settings, std::string folder)
      : settings_(settings), folder_(std::move(folder)) {}

  [[nodiscard]] bool wanted() const;

  // The temporary files. Errors: of the folder. REQUIRES: wanted(); called once.
  [[nodiscard]] core::Status make_spools(WarningBox& warnings);

  // Takes all of the part's slices, and finds what of them has to be solid. Returns early when
  // asked to stop. Errors: of the source, of the disk.
  // COSTS: slicing, which then is done, the wall's offsets and its window; the fold.
  // REQUIRES: the spools are made; called once.
  [[nodiscard]] core::Status prepare(const Source& source, int threads, const Stopped& stopped,
                                     Told told);

  // What the source gave, from the bed up. REQUIRES: prepared.
  [[nodiscard]] core::Result<TakenSlice> next_slice();

  // The layer with its wall and its inside. Errors: of the disk.
  // REQUIRES: prepared; indices ascend.
  [[nodiscard]] core::Result<core::SplitLayer> split(core::Layer layer);

  [[nodiscard]] std::int64_t spooled_bytes() const;
  // Of the first pass and of the fold.
  [[nodiscard]] const StageUse& use() const { return use_; }
  [[nodiscard]] std::int64_t offset_retries() const { return offset_retries_; }
  [[nodiscard]] const core::WallSplitter::Usage& window() const { return window_; }

 private:
  class FirstPass;

  [[nodiscard]] core::Status fold(const Stopped& stopped, Told told);
  [[nodiscard]] core::Status take_decided(core::RoofFold& fold, core::LightningFold& lightning);
  [[nodiscard]] core::Status step_up();

  const core::Settings& settings_;
  std::string folder_;
  std::optional<LayerSpool> slices_, given_, decided_;
  std::optional<RecordSpool> branches_;
  std::optional<SpooledLayer> latest_;  // of the decided ones
  std::shared_ptr<const core::Branches> latest_branches_, branches_below_;
  StageUse use_;
  std::int64_t offset_retries_ = 0;
  core::WallSplitter::Usage window_;
};

}  // namespace host
