#include "host/monitor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/check.h"
#include "firmware_link/dialects/marlin_dialect.h"
#include "firmware_link/link_step.h"
#include "host/port_clock.h"

namespace host {
namespace {

using firmware_link::Command;
using firmware_link::Instant;
using firmware_link::SessionState;

// How long one turn waits for an answer. Short, because a command that geometry has just put into
// an empty queue waits as long.
constexpr int kWait_ms = 5;
// How long a controller that has faulted may take to accept the last bytes.
constexpr double kLastWords_s = 2;

}  // namespace

Monitor::Monitor(const core::Settings& settings, MonitorOptions options,
                 firmware_link::BytePort& port, CommandQueue& queue, Reporter& reporter)
    : settings_(settings),
      options_(std::move(options)),
      port_(port),
      queue_(queue),
      reporter_(reporter),
      session_(std::make_unique<firmware_link::MarlinDialect>(), {}, link_now()) {
  RIND_CHECK(options_.stop_count != nullptr);
  RIND_CHECK(options_.slices_cut != nullptr);
  RIND_CHECK(options_.layers != nullptr);
  RIND_CHECK(options_.warnings != nullptr);
}

LinkOutcome Monitor::run() {
  statistics_.clock.enter(Stage::kSend);
  while (true) {
    if (options_.stop_count() > 0) return stop(LinkEnd::kUserStopped);
    if (queue_.closed()) return stop(LinkEnd::kGeometryEnded);
    const Instant now = link_now();
    feed(now);
    firmware_link::step(session_, port_, now, session_.can_take() ? 0 : kWait_ms);
    note_acknowledged();
    tell_events();
    report_progress();
    if (session_.state() == SessionState::kFinished) return outcome(LinkEnd::kDone);
    if (session_.state() == SessionState::kFaulted) return faulted();
  }
}

void Monitor::feed(Instant now) {
  while (session_.can_take()) {
    if (!waiting_) waiting_ = queue_.try_pop();
    if (!waiting_) break;
    // Before a layer, and before the user's own lines, which may move anything.
    const bool unknown = std::holds_alternative<firmware_link::Verbatim>(waiting_->command);
    if (unchecked_road_ && (waiting_->layer != last_.layer || unknown)) {
      unchecked_road_ = false;
      session_.check_position(now);
      continue;
    }
    const QueuedCommand queued = *std::exchange(waiting_, std::nullopt);
    unchecked_road_ = unchecked_road_ || queued.lays_road;
    take(queued, now);
  }
  if (!finish_said_ && session_.state() == SessionState::kStreaming && !waiting_ &&
      queue_.drained() && !queue_.closed()) {
    session_.finish(now);
    finish_said_ = true;
  }
}

void Monitor::take(const QueuedCommand& queued, Instant now) {
  session_.take(queued.command, now);
  ++taken_;
  if (queued.lays_road && first_road_ == 0) first_road_ = taken_;
  if (const auto* move = std::get_if<firmware_link::Move>(&queued.command); move && move->z_um) {
    z_um_ = *move->z_um;
  } else if (std::holds_alternative<firmware_link::Verbatim>(queued.command)) {
    z_um_ = -1;  // it may have moved anything
  }
  if (queued.layer != last_.layer) statistics_.clock.end_layer();
  last_ = queued;
}

void Monitor::note_acknowledged() {
  const firmware_link::SessionStatistics link = session_.statistics();
  statistics_.commands = link.commands_acknowledged;
  statistics_.stalls = link.stalls;
  statistics_.resends = link.resends;
  statistics_.resend_ratio = link.resend_ratio();
  statistics_.planner_low_s = link.planner_low_s;
  if (!statistics_.first_command_s && link.commands_acknowledged > 0) {
    statistics_.first_command_s = steady_seconds() - options_.began_s;
  }
  if (!statistics_.first_road_s && first_road_ > 0 && link.commands_acknowledged >= first_road_) {
    statistics_.first_road_s = steady_seconds() - options_.began_s;
    statistics_.first_road_cpu_s = process_cpu_seconds();
    statistics_.slices_cut_at_first_road = options_.slices_cut();
  }
}

void Monitor::tell_events() {
  using Kind = firmware_link::SessionEvent::Kind;
  while (const auto event = session_.next_event()) {
    switch (event->kind) {
      case Kind::kDialect:
        reporter_.note("controller", session_.firmware_name() + ", speaks as " + event->text);
        break;
      case Kind::kWarning:
        reporter_.note("warning", "the controller says: " + event->text);
        break;
      case Kind::kWaitsForUser:
        reporter_.note("waiting", "the printer waits for its user");
        break;
      case Kind::kResendsFrequent:
        reporter_.note("resends", event->text);
        break;
      case Kind::kFilamentCorrected:
        reporter_.note("corrected", "a line ran in part: " + event->text + ", made up for");
        break;
      default:
        reporter_.note("action", "the printer asks: " + event->text);
        break;
    }
  }
}

void Monitor::report_progress() {
  const double now = steady_seconds();
  for (const std::string& warning : options_.warnings()) reporter_.note("warning", warning);
  if (!reporter_.progress_due(now)) return;
  ProgressReport report;
  report.layer = last_.layer;
  report.layers = options_.layers();
  report.height = last_.top;
  report.filament_mm = last_.filament_mm;
  report.elapsed_s = now - options_.began_s;
  if (statistics_.first_road_s && last_.layer > 1 && report.layers > 0) {
    const double printing_s = report.elapsed_s - *statistics_.first_road_s;
    report.left_s = printing_s * static_cast<double>(report.layers - last_.layer + 1) /
                    static_cast<double>(last_.layer - 1);
  }
  const firmware_link::SessionStatistics link = session_.statistics();
  report.nozzle_celsius = link.temperatures.nozzle_celsius;
  report.nozzle_target_celsius = link.temperatures.nozzle_target_celsius;
  report.bed_celsius = link.temperatures.bed_celsius;
  report.bed_target_celsius = link.temperatures.bed_target_celsius;
  report.lines_in_flight = link.lines_in_flight;
  report.queue_share =
      static_cast<double>(queue_.level().items) / static_cast<double>(queue_.limits().items);
  reporter_.progress(report, now);
}

std::vector<Command> Monitor::safe_sequence() const {
  using firmware_link::Heater;
  std::vector<Command> commands;
  if (first_road_ > 0 && settings_.retraction_mm > 0) {
    firmware_link::Move retract;
    retract.extruding = true;
    retract.e_10nm = -std::llround(settings_.retraction_mm * 1e5);
    retract.f_mm_min = std::llround(settings_.retraction_speed_mm_s * 60);
    commands.emplace_back(retract);
  }
  if (first_road_ > 0 && z_um_ >= 0) {
    std::int64_t lifted_um = z_um_ + settings_.park_lift.units() / 10;
    if (settings_.axis_z > core::Length()) {
      lifted_um = std::max(z_um_, std::min(lifted_um, settings_.axis_z.units() / 10));
    }
    firmware_link::Move lift;
    lift.z_um = lifted_um;
    lift.f_mm_min = std::llround(settings_.lift_speed_mm_s * 60);
    commands.emplace_back(lift);
  }
  commands.emplace_back(firmware_link::SetTemperature{Heater::kNozzle, 0, false});
  commands.emplace_back(firmware_link::SetTemperature{Heater::kBed, 0, false});
  commands.emplace_back(firmware_link::SetFan{0});
  return commands;
}

LinkOutcome Monitor::outcome(LinkEnd end) const {
  LinkOutcome outcome;
  outcome.end = end;
  if (first_road_ > 0) {
    outcome.layer = last_.layer;
    outcome.height = last_.top;
  }
  return outcome;
}

LinkOutcome Monitor::stop(LinkEnd end) {
  LinkOutcome result = outcome(end);
  if (taken_ == 0) return result;  // nothing was heated or moved
  session_.stop_now(safe_sequence(), link_now());
  while (session_.state() != SessionState::kStopped) {
    if (options_.stop_count() > 1) return halt();
    firmware_link::step(session_, port_, link_now(), kWait_ms);
    if (session_.state() != SessionState::kFaulted) continue;
    LinkOutcome halted = halt();
    halted.end = end == LinkEnd::kUserStopped ? end : LinkEnd::kFaulted;
    halted.reason = session_.reason();
    halted.measures = "the controller did not confirm the safe stop (" + session_.reason() +
                      "), so it was told to halt (M112); check that the heaters are off";
    return halted;
  }
  flush_output(kLastWords_s);
  note_acknowledged();
  result.measures = result.layer > 0 ? "nozzle lifted, heaters and fan off" : "heaters and fan off";
  return result;
}

LinkOutcome Monitor::halt() {
  LinkOutcome result = outcome(LinkEnd::kUserHalted);
  constexpr int kAttempts = static_cast<int>(kLastWords_s * 1000) / kWait_ms;
  const firmware_link::Halt halted = firmware_link::halt(session_, port_, kWait_ms, kAttempts);
  switch (halted) {
    case firmware_link::Halt::kTold:
      result.measures = "controller halted (M112); it needs a reset";
      break;
    case firmware_link::Halt::kReset:
      result.measures = "controller told to halt (M112) and reset";
      break;
    case firmware_link::Halt::kMaybe:
      result.measures =
          "controller told to halt (M112); it has no emergency parser, so it may act late: switch "
          "it off";
      break;
    case firmware_link::Halt::kNotSent:
      result.measures = "the halt (M112) could not be sent: switch the printer off";
      break;
  }
  return result;
}

LinkOutcome Monitor::emergency(const std::string& reason) {
  LinkOutcome result = halt();
  result.end = LinkEnd::kFaulted;
  result.reason = "the link gave up: " + reason;
  return result;
}

LinkOutcome Monitor::faulted() {
  LinkOutcome result = outcome(LinkEnd::kFaulted);
  result.reason = session_.reason();
  if (taken_ == 0) return result;
  if (port_.state() == firmware_link::PortState::kLost) {
    result.measures = "nothing more could be sent: check that the heaters are off";
    return result;
  }
  if (session_.fault_kind() == firmware_link::FaultKind::kHeater) {
    result.measures = halt().measures;
    return result;
  }
  session_.stop_now(safe_sequence(), link_now());
  flush_output(kLastWords_s);
  result.measures = "heaters off and a lift were sent, but not confirmed: check the printer";
  return result;
}

void Monitor::flush_output(double limit_s) {
  const double until_s = steady_seconds() + limit_s;
  while (!session_.output().empty() && port_.state() == firmware_link::PortState::kOpen &&
         steady_seconds() < until_s) {
    const Instant now = link_now();
    session_.written(port_.write(session_.output()), now);
    std::byte answer[256];
    (void)port_.read(answer, kWait_ms);
  }
}

}  // namespace host
