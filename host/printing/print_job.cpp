#include "host/printing/print_job.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "host/files/input_file.h"
#include "host/pipeline/pipeline.h"
#include "host/printing/monitor.h"
#include "host/printing/queue_filler.h"
#include "host/printing/slow_layer_note.h"
#include "host/system/exit_codes.h"
#include "host/system/limits.h"
#include "host/system/stop_signals.h"

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

// What both threads hold. It lives until both are done with it: the geometry may be left behind in
// the middle of a layer.
struct Shared {
  Shared(const PrintRequest& request, const JournalRecord* resumed_from)
      : job(request.job),
        resumed(resumed_from != nullptr ? std::optional(*resumed_from) : std::nullopt),
        filler(queue, job.settings, resumed ? &*resumed : nullptr) {}

  Job& job;
  const std::optional<JournalRecord> resumed;
  CommandQueue queue{{kQueuedCommandsMax, kQueuedBytesMax}};
  QueueFiller filler;
  PipelineSignals signals;
  ArcsAnswer arcs;
  std::atomic<bool> link_ended = false;
  GeometryOutcome geometry;  // valid when it has ended
  std::promise<void> ended;
};

GeometryOutcome run_geometry(Shared& shared) {
  GeometryOutcome outcome;
  bool whole = false;
  QueueFiller& filler = shared.filler;
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
        run_pipeline(shared.job, outputs, shared.signals, outcome.statistics);
    if (!end.ok()) {
      outcome.error = end.error().message;
    } else if (end.value() == PipelineEnd::kDone) {
      (void)filler.finish();
      whole = true;
    }
    if (!outcome.error) outcome.error = filler.error();
  } catch (const std::exception& error) {
    outcome.error = std::string("the geometry gave up: ") + error.what();
  }
  if (whole && !outcome.error) {
    shared.queue.finish();
  } else {
    shared.queue.close();
  }
  return outcome;
}

// Waits for the geometry's end, so long as the request says. False: it is left where it is.
bool joined(std::thread& thread, Shared& shared, const PrintRequest& request) {
  if (request.geometry_grace_s) {
    const std::chrono::duration<double> grace(*request.geometry_grace_s);
    if (shared.ended.get_future().wait_for(grace) != std::future_status::ready) {
      thread.detach();
      return false;
    }
  }
  thread.join();
  return true;
}

std::string where(const LinkOutcome& link, core::LayerIndex layers) {
  if (link.layer == 0) return "before the first road";
  const std::string of = layers > 0 ? fmt::format(" of {}", layers) : "";
  return fmt::format("at layer {}{}, height {:.2f} mm", link.layer, of, link.height.mm());
}

std::string told(std::string message, const std::string& measures) {
  return measures.empty() ? message : message + "; " + measures;
}

void conclude(const LinkOutcome& link, const GeometryOutcome& geometry, core::LayerIndex layers,
              double began_s, PrintOutcome& outcome) {
  switch (link.end) {
    case LinkEnd::kDone:
      outcome.exit_code = kExitDone;
      outcome.message =
          fmt::format("printed {} layers, {:.2f} m of filament in {}", geometry.statistics.layers,
                      total_mm(geometry.statistics.filament_mm) / 1'000,
                      duration_text(steady_seconds() - began_s));
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
  const JournalRecord* resumed =
      request.link.resumption ? &request.link.resumption->record : nullptr;
  if (resumed != nullptr) request.job.start = resumed->checkpoint;
  const auto shared = std::make_shared<Shared>(request, resumed);
  PipelineSignals& signals = shared->signals;
  signals.stop_asked = [&shared = *shared] {
    return shared.link_ended.load() || stop_signal_count() > 0;
  };
  signals.on_slow_layer = [&reporter = request.reporter](const SlowLayer& slow) {
    tell_slow_layer(slow, reporter);
  };
  MonitorOptions options = request.link;
  options.part = request.job.part.summary.box;
  options.height = request.job.part.summary.height;
  request.job.draws_arcs = [&arcs = shared->arcs] { return arcs.wait(); };
  options.controller_known = [&arcs = shared->arcs](const firmware_link::Capabilities& controller) {
    arcs.tell(controller.arcs);
  };
  std::thread thread([shared] {
    shared->geometry = run_geometry(*shared);
    shared->ended.set_value();
  });
  LinkOutcome link;
  options.seconds_made = [shared] { return shared->filler.seconds_made(); };
  options.layers = [&signals] { return signals.layers.load(); };
  options.warnings = [&signals] { return signals.warnings.take(); };
  options.began_s = request.began_s;
  options.stop_count = request.stop_count;
  options.slices_cut = [&signals] { return signals.slices_cut.load(); };
  Monitor monitor(request.job.settings, std::move(options), request.port, shared->queue,
                  request.reporter);
  try {
    link = monitor.run();
  } catch (const std::exception& error) {
    // The session's state is not to be trusted any more; its controller is made safe from outside.
    link = monitor.emergency(error.what());
  }
  shared->link_ended.store(true);
  shared->queue.close();
  shared->arcs.tell(false);
  stop_waiting_for_input();
  GeometryOutcome geometry;
  if (joined(thread, *shared, request)) {
    geometry = std::move(shared->geometry);
  } else {
    geometry.statistics.ended = false;
  }
  for (const std::string& warning : signals.warnings.take()) {
    request.reporter.note("warning", warning);
  }

  PrintOutcome outcome;
  conclude(link, geometry, signals.layers.load(), request.began_s, outcome);
  outcome.geometry = std::move(geometry.statistics);
  outcome.link = monitor.statistics();
  return outcome;
}

}  // namespace host
