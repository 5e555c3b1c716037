// Puts the commands of a ready G-code file into the queue, as the pipeline does with those of a
// part.
//
// A checkpoint is a place in the file: kCheckpointCommands apart at most, and at each line that
// sets the controller up, so that a checkpoint always has all that was set up before. A resumed
// print reads on from the journal's.
#pragma once

#include <cstdint>

#include "core/result.h"                   // Result
#include "host/pipeline/pipeline.h"        // PrintPlan, PipelineSignals
#include "host/pipeline/statistics.h"      // GeometryStatistics
#include "host/printing/journal_record.h"  // JournalRecord
#include "host/printing/queue_filler.h"    // QueueFiller

namespace host {

inline constexpr std::int64_t kCheckpointCommands = 256;

// To the file's end; false: the queue was closed, or a stop was asked for. `resumed`: the record
// that the print resumes from; null: from the start. REQUIRES: print_plan.ready was scanned.
[[nodiscard]] core::Result<bool> run_ready(const PrintPlan& print_plan,
                                           const JournalRecord* resumed, QueueFiller& filler,
                                           PipelineSignals& signals,
                                           GeometryStatistics& statistics);

}  // namespace host
