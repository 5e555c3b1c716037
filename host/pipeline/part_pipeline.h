// The pipeline of one part, as pipeline.h draws it, up to its last layer's motions. Its last step
// is shared by objects that are printed one after another.
#pragma once

#include <atomic>

#include "core/result.h"                  // Result
#include "host/pipeline/command_stage.h"  // CommandStage
#include "host/pipeline/pipeline.h"       // PrintPlan, PipelineOutputs, PipelineSignals
#include "host/pipeline/statistics.h"     // GeometryStatistics

namespace host {

// Runs the part to its last layer, or until an output or a signal stops the run; kDone, too, once
// its object is cancelled. `refused` is set where the run is stopped. Errors: as run_pipeline().
// REQUIRES: `commands` is of the same print, and stands where the part begins.
[[nodiscard]] core::Result<PipelineEnd> run_part(
    PrintPlan& print_plan, const PipelineOutputs& outputs, PipelineSignals& signals,
    GeometryStatistics& statistics, CommandStage& commands, std::atomic<bool>& refused);

}  // namespace host
