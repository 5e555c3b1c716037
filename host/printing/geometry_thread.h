// The thread that computes a print's commands, and what the link's thread sees of it.
//
//     run_pipeline ──> MotionEncoder ──> QueueFiller ──> [ queue ]        this thread
//                                                          │
//                     signals, seconds made, capabilities  ▼              the link's
//
// Both threads share a state that lives until both are done with it: the geometry may be left
// behind in the middle of a layer.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "host/pipeline/pipeline.h"        // CommandForm, PrintPlan, PipelineSignals
#include "host/pipeline/statistics.h"      // GeometryStatistics
#include "host/printing/journal_record.h"  // JournalRecord
#include "host/printing/progress.h"        // Reporter
#include "host/printing/queued_command.h"  // CommandQueue

namespace host {

struct GeometryOutcome {
  std::optional<std::string> error;
  GeometryStatistics statistics;  // `ended` false: it was left behind, and runs on
};

class GeometryThread {
 public:
  // Starts it. `resumed_from`: of a print that is resumed; null: from the first layer. The plan and
  // the reporter outlive the thread, also when it is left behind.
  GeometryThread(PrintPlan& print_plan, const JournalRecord* resumed_from, Reporter& reporter);
  // Ends it where end() was not called, because of an exception; waits for it then.
  ~GeometryThread();
  GeometryThread(const GeometryThread&) = delete;
  GeometryThread& operator=(const GeometryThread&) = delete;

  [[nodiscard]] CommandQueue& queue();
  [[nodiscard]] PipelineSignals& signals();
  // Of motion at full speed, queued so far.
  [[nodiscard]] double seconds_made() const;

  // What the controller understands: geometry waits for it before the first layer's motions.
  void tell_controller(const CommandForm& form);

  // The link has ended: closes the queue and waits for the geometry, for `grace_s` at most.
  // Nothing: as long as it takes. To be called once.
  [[nodiscard]] GeometryOutcome end(std::optional<double> grace_s);

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  std::thread thread_;
};

}  // namespace host
