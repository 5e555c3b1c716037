// Where a print's slices come from. What comes before the first layer is done here: the rest of the
// part is read where it has to be, and what is known only from above is found, supports and the
// inside that holds up its roof.
//
//     SliceIntake ──> SupportStage, if wanted ──> InsideStage, if wanted ──> next_slice()
#pragma once

#include <functional>

#include "core/result.h"                  // Result, Status
#include "core/settings.h"                // Settings
#include "core/units.h"                   // LayerIndex
#include "host/pipeline/inside_stage.h"   // InsideStage
#include "host/pipeline/layer_watch.h"    // LayerWatch
#include "host/pipeline/pipeline.h"       // PrintPlan, PipelineSignals
#include "host/pipeline/slice_intake.h"   // SliceIntake, TakenSlice
#include "host/pipeline/statistics.h"     // GeometryStatistics
#include "host/pipeline/support_stage.h"  // SupportStage

namespace host {

class PartSource {
 public:
  using Stopped = std::function<bool()>;

  // `settings`: of the part, above its raft. `stopped`: whether to end early. What is passed by
  // reference outlives the source.
  PartSource(PrintPlan& print_plan, const core::Settings& settings, PipelineSignals& signals,
             const Stopped& stopped);

  // `preheat` is called once, if the first slice has to wait; temporary files are made before.
  // `watch` sees layers whose supports take long. Returns early when asked to stop. Errors: of the
  // part, of the disk.
  [[nodiscard]] core::Status prepare(const std::function<void()>& preheat, LayerWatch& watch);

  // From the bed up. Errors: of the part, of the disk. REQUIRES: prepare() was fine.
  [[nodiscard]] core::Result<TakenSlice> next_slice();

  [[nodiscard]] SupportStage& supports() { return supports_; }
  [[nodiscard]] InsideStage& inside() { return inside_; }
  // Slices that were taken so far.
  [[nodiscard]] core::LayerIndex taken() const { return intake_.taken(); }

  // Adds what all of it has cost. `sliced_before_s`: the stage's time before this part.
  void tell(GeometryStatistics& statistics, double sliced_before_s) const;

 private:
  [[nodiscard]] core::Status make_spools();
  [[nodiscard]] core::Status read_rest();
  [[nodiscard]] core::Result<TakenSlice> next_supported();

  PrintPlan& plan_;
  PipelineSignals& signals_;
  core::Settings settings_;
  Stopped stopped_;
  SliceIntake intake_;
  InsideStage inside_;
  SupportStage supports_;
};

}  // namespace host
