#include "host/printing/geometry_thread.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <future>
#include <mutex>
#include <new>
#include <utility>

#include "host/files/input_file.h"  // stop_waiting_for_input
#include "host/printing/queue_filler.h"
#include "host/printing/ready_commands.h"
#include "host/printing/slow_layer_note.h"
#include "host/system/limits.h"
#include "host/system/memory_budget.h"  // memory_refusal
#include "host/system/stop_signals.h"

namespace host {
namespace {

// What the controller understands: geometry waits for it, the link tells.
class FormPromise {
 public:
  // The first one counts.
  void tell(const CommandForm& form) {
    const std::lock_guard lock(mutex_);
    if (!form_) form_ = form;
    told_.notify_all();
  }

  [[nodiscard]] CommandForm wait() {
    std::unique_lock lock(mutex_);
    told_.wait(lock, [this] { return form_.has_value(); });
    return *form_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable told_;
  std::optional<CommandForm> form_;
};

}  // namespace

struct GeometryThread::Shared {
  Shared(PrintPlan& plan_of_print, const JournalRecord* resumed_from)
      : print_plan(plan_of_print),
        resumed(resumed_from != nullptr ? std::optional(*resumed_from) : std::nullopt),
        filler(queue, print_plan.settings, resumed ? &*resumed : nullptr) {}

  void run();
  [[nodiscard]] bool make_commands();

  PrintPlan& print_plan;
  const std::optional<JournalRecord> resumed;
  CommandQueue queue{{kQueuedCommandsMax, kQueuedBytesMax}};
  QueueFiller filler;
  PipelineSignals signals;
  FormPromise form;
  std::atomic<bool> link_ended = false;
  GeometryOutcome outcome;  // valid when it has ended
  std::promise<void> ended;
};

// The thread's work, to its end; false: it was stopped.
bool GeometryThread::Shared::make_commands() {
  if (print_plan.ready) {
    const core::Result<bool> whole =
        run_ready(print_plan, resumed ? &*resumed : nullptr, filler, signals, outcome.statistics);
    if (!whole.ok()) outcome.error = whole.error().message;
    return whole.ok() && whole.value();
  }
  PipelineOutputs outputs;
  outputs.on_checkpoint = [this](const Checkpoint& checkpoint) { filler.start_layer(checkpoint); };
  outputs.on_pause = [this](const std::string& why) { filler.pause(why); };
  outputs.on_motion = [this](const core::Motion& motion,
                             const std::optional<firmware_link::Command>& command) {
    return filler.take(motion, command);
  };
  const core::Result<PipelineEnd> end =
      run_pipeline(print_plan, outputs, signals, outcome.statistics);
  if (!end.ok()) outcome.error = end.error().message;
  return end.ok() && end.value() == PipelineEnd::kDone;
}

void GeometryThread::Shared::run() {
  bool whole = false;
  try {
    whole = make_commands();
    if (whole) (void)filler.finish();
    if (!outcome.error) outcome.error = filler.error();
  } catch (const std::bad_alloc&) {
    outcome.error = memory_refusal() + "; allow more, or simplify the part";
  } catch (const std::exception& error) {
    outcome.error = std::string("the geometry gave up: ") + error.what();
  }
  if (whole && !outcome.error) {
    queue.finish();
  } else {
    queue.close();
  }
  ended.set_value();
}

GeometryThread::GeometryThread(PrintPlan& print_plan, const JournalRecord* resumed_from,
                               Reporter& reporter) {
  if (resumed_from != nullptr) print_plan.start = resumed_from->checkpoint;
  shared_ = std::make_shared<Shared>(print_plan, resumed_from);
  if (resumed_from != nullptr) shared_->signals.objects.restore(resumed_from->cancelled);
  shared_->signals.stop_asked = [shared = shared_.get()] {
    return shared->link_ended.load() || stop_signal_count() > 0;
  };
  shared_->signals.on_slow_layer = [&reporter](const SlowLayer& slow) {
    tell_slow_layer(slow, reporter);
  };
  print_plan.command_form = [&form = shared_->form] { return form.wait(); };
  thread_ = std::thread([shared = shared_] { shared->run(); });
}

// Without end(), an exception has ended the link: the geometry has nobody to work for.
GeometryThread::~GeometryThread() {
  if (thread_.joinable()) (void)end(std::nullopt);
}

CommandQueue& GeometryThread::queue() { return shared_->queue; }

PipelineSignals& GeometryThread::signals() { return shared_->signals; }

double GeometryThread::seconds_made() const { return shared_->filler.seconds_made(); }

void GeometryThread::tell_controller(const CommandForm& form) { shared_->form.tell(form); }

GeometryOutcome GeometryThread::end(std::optional<double> grace_s) {
  shared_->link_ended.store(true);
  shared_->queue.close();
  shared_->form.tell({.arcs = false});
  stop_waiting_for_input();
  if (grace_s && shared_->ended.get_future().wait_for(std::chrono::duration<double>(*grace_s)) !=
                     std::future_status::ready) {
    thread_.detach();
    GeometryOutcome left_behind;
    left_behind.statistics.ended = false;
    return left_behind;
  }
  thread_.join();
  return std::move(shared_->outcome);
}

}  // namespace host
