#include "host/printing/print_job.h"

#include <fmt/format.h>

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "host/exit_codes.h"
#include "host/limits.h"
#include "host/part/input_file.h"
#include "host/pipeline/pipeline.h"
#include "host/printing/monitor.h"
#include "host/printing/queue_filler.h"

namespace host {
namespace {

// What the geometry thread leaves behind.
struct GeometryOutcome {
  std::optional<std::string> error;
  GeometryStatistics statistics;
};

// Whether the controller draws arcs: geometry waits for it, the link tells.
class ArcsAnswer {
 public:
  // The first one counts.
  void tell(bool drawn) {
    const std::lock_guard lock(mutex_);
    if (!drawn_) drawn_ = drawn;
    told_.notify_all();
  }

  [[nodiscard]] bool wait() {
    std::unique_lock lock(mutex_);
    told_.wait(lock, [this] { return drawn_.has_value(); });
    return *drawn_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable told_;
  std::optional<bool> drawn_;
};

GeometryOutcome run_geometry(const PrintRequest& request, CommandQueue& queue, QueueFiller& filler,
                             PipelineSignals& signals) {
  GeometryOutcome outcome;
  try {
    PipelineOutputs outputs;
    outputs.on_checkpoint = [&filler](const Checkpoint& checkpoint) {
      filler.begin_layer(checkpoint);
    };
    outputs.on_pause = [&filler](const std::string& why) { filler.pause(why); };
    outputs.on_motion = [&filler](const core::Motion& motion,
                                  const std::optional<firmware_link::Command>& command) {
      return filler.take(motion, command);
    };
    const core::Result<PipelineEnd> end =
        run_pipeline(request.job, outputs, signals, outcome.statistics);
    if (!end.ok()) {
      outcome.error = end.error().message;
    } else if (end.value() == PipelineEnd::kDone) {
      (void)filler.finish();
    }
    if (!outcome.error) outcome.error = filler.error();
  } catch (const std::exception& error) {
    outcome.error = std::string("the geometry gave up: ") + error.what();
  }
  if (outcome.error) {
    queue.close();
  } else {
    queue.finish();
  }
  return outcome;
}

std::string where(const LinkOutcome& link, core::LayerIndex layers) {
  if (link.layer == 0) return "before the first road";
  const std::string of = layers > 0 ? fmt::format(" of {}", layers) : "";
  return fmt::format("at layer {}{}, height {:.2f} mm", link.layer, of, link.height.mm());
}

std::string told(std::string message, const std::string& measures) {
  return measures.empty() ? message : message + "; " + measures;
}

void conclude(const LinkOutcome& link, const GeometryOutcome& geometry, const PrintRequest& request,
              PrintOutcome& outcome) {
  const core::LayerIndex layers = request.job.part.summary.layers;
  switch (link.end) {
    case LinkEnd::kDone:
      outcome.exit_code = kExitDone;
      outcome.message =
          fmt::format("printed {} layers, {:.2f} m of filament in {}", geometry.statistics.layers,
                      total_mm(geometry.statistics.filament_mm) / 1'000,
                      duration_text(steady_seconds() - request.began_s));
      return;
    case LinkEnd::kUserStopped:
    case LinkEnd::kUserHalted:
      outcome.exit_code = kExitStopped;
      outcome.message = told("stopped " + where(link, layers), link.measures);
      return;
    case LinkEnd::kGeometryEnded:
      outcome.exit_code = kExitBadInput;
      outcome.message = geometry.error.value_or("the geometry ended early");
      if (link.layer > 0 || !link.measures.empty()) {
        outcome.message = told(outcome.message + "; stopped " + where(link, layers), link.measures);
      }
      return;
    case LinkEnd::kRefused:
      outcome.exit_code = kExitBadInput;
      outcome.message = told(link.reason, link.measures);
      return;
    case LinkEnd::kFaulted:
      outcome.exit_code = kExitLinkFault;
      outcome.message = told(link.reason + "; stopped " + where(link, layers), link.measures);
      return;
  }
}

}  // namespace

PrintOutcome print_part(const PrintRequest& request) {
  CommandQueue queue({kQueuedCommandsMax, kQueuedBytesMax});
  PipelineSignals signals;
  std::atomic<bool> link_ended = false;
  signals.stop_asked = [&link_ended] { return link_ended.load(); };

  const JournalRecord* resumed =
      request.link.resumption ? &request.link.resumption->record : nullptr;
  if (resumed != nullptr) request.job.start = resumed->checkpoint;
  QueueFiller filler(queue, request.job.settings, resumed);
  MonitorOptions options = request.link;
  options.part = request.job.part.summary.box;
  options.height = request.job.part.summary.height;
  ArcsAnswer arcs;
  request.job.draws_arcs = [&arcs] { return arcs.wait(); };
  options.controller_known = [&arcs](const firmware_link::Capabilities& controller) {
    arcs.tell(controller.arcs);
  };
  GeometryOutcome geometry;
  std::thread thread([&] { geometry = run_geometry(request, queue, filler, signals); });
  LinkOutcome link;
  options.seconds_made = [&filler] { return filler.seconds_made(); };
  options.layers = [&signals] { return signals.layers.load(); };
  options.warnings = [&signals] { return signals.warnings.take(); };
  options.began_s = request.began_s;
  options.stop_count = request.stop_count;
  options.slices_cut = [&signals] { return signals.slices_cut.load(); };
  Monitor monitor(request.job.settings, std::move(options), request.port, queue, request.reporter);
  try {
    link = monitor.run();
  } catch (const std::exception& error) {
    // The session's state is not to be trusted any more; its controller is made safe from outside.
    link = monitor.emergency(error.what());
  }
  link_ended.store(true);
  queue.close();
  arcs.tell(false);
  stop_waiting_for_input();
  thread.join();
  for (const std::string& warning : signals.warnings.take()) {
    request.reporter.note("warning", warning);
  }

  PrintOutcome outcome;
  conclude(link, geometry, request, outcome);
  outcome.geometry = std::move(geometry.statistics);
  outcome.link = monitor.statistics();
  return outcome;
}

}  // namespace host
