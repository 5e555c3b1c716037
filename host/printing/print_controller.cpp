#include "host/printing/print_controller.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>
#include <variant>

#include "host/gcode/line_meaning.h"   // percent_set_by
#include "host/printing/port_clock.h"  // link_now
#include "host/printing/skipped_command.h"
#include "host/system/limits.h"
#include "host/system/stage_clock.h"  // steady_seconds

namespace host {
namespace {

using firmware_link::FaultKind;
using firmware_link::Instant;
using firmware_link::SessionState;

constexpr auto kReopenPause = std::chrono::milliseconds(200);

}  // namespace

PrintController::PrintController(const PrintSettings& settings, const PrintOptions& options,
                                 const PartExtent& part, const Parts& parts, double started_s)
    : options_(options),
      geometry_(parts.geometry),
      control_(parts.control),
      reporter_(parts.reporter),
      link_(settings, {options.banner_wait_s, options.count_filament}, parts.port),
      commands_(geometry_.queue()),
      start_(settings, options.space.value_or(space_of(settings)), part),
      pauses_(start_.park_moves(), options.hot_s),
      underrun_(options.underrun_s),
      journal_(commands_, pauses_, geometry_.signals().layers, control_, reporter_),
      reports_(started_s, commands_, geometry_.signals(), reporter_),
      recovery_({link_, commands_, pauses_, start_, journal_, control_, reporter_},
                options.resumption),
      ending_({link_, commands_, pauses_, feed_, start_, journal_, reports_, control_}) {
  journal_.watch(geometry_.signals().objects);
  reports_.count_down(options.spool_left_mm, options.resumption.has_value());
  if (options.resumption) pauses_.set_last_planned(options.resumption->record.last_planned);
  link_.start_session(recovery_.searching());
}

LinkOutcome PrintController::run() {
  reports_.statistics().clock.enter(Stage::kSend);
  while (true) {
    if (stop_asked()) return ending_.stop(LinkEnd::kUserStopped);
    if (geometry_.queue().closed()) return ending_.stop(LinkEnd::kGeometryEnded);
    const Instant now = link_now();
    take_requests(now);
    watch_underrun(now);
    feed(now);
    if (!refused_.empty()) return ending_.stop(LinkEnd::kRefused, refused_);
    if (!recovery_.failure().empty()) return ending_.not_resumed(recovery_.failure());
    keep_journal();
    link_.step(now);
    reports_.note_counts(session().statistics());
    hear_events();
    reports_.show_progress(session());
    if (session().state() == SessionState::kFinished) return ending_.done();
    if (session().state() != SessionState::kFaulted) continue;
    if (!recoverable()) return ending_.faulted();
    if (const std::optional<LinkOutcome> end = recover()) return *end;
  }
}

// Once, when the controller has said what it can do: whether the print may start.
bool PrintController::started(Instant now) {
  if (started_) return true;
  if (session().state() != SessionState::kStreaming || !start_.travel_asked(link_, now)) {
    return false;
  }
  started_ = true;
  core::Status may = start_.take_travel(session(), reporter_);
  pauses_.set_park_moves(start_.park_moves());
  if (may.ok()) may = control_.may_start();
  if (!may.ok()) {
    refused_ = may.error().message;
    return false;
  }
  geometry_.tell_controller({session().capabilities().arcs, session().rules().flavor});
  return true;
}

void PrintController::feed(Instant now) {
  if (!started(now)) return;
  while (session().can_take() && feed_one(now)) {
  }
  if (!all_given_ && session().state() == SessionState::kStreaming && !recovery_.searching() &&
      pauses_.printing() && commands_.ended()) {
    session().finish(now);
    all_given_ = true;
  }
}

// False when there is nothing to give at the moment. REQUIRES: the session can take a command.
bool PrintController::feed_one(Instant now) {
  if (const std::optional<firmware_link::Command> command = pauses_.next()) {
    link_.insert(*command, now);
    return true;
  }
  if (pauses_.advance_due() && pauses_.advance(steady_seconds(), commands_.state())) {
    note_phase(now);
    return true;
  }
  if (!pauses_.printing()) return false;
  if (recovery_.searching()) {
    if (!recovery_.find_start()) return false;
    const MachineState here = commands_.state();
    feed_.file_set_feed(here.feed_percent);
    feed_.file_set_flow(here.flow_percent);
  }
  if (commands_.peek() == nullptr) return false;
  if (commands_.next_was_executed()) {
    commands_.skip();
    return true;
  }
  return recovery_.start_way_back(now) || give_next(now);
}

// REQUIRES: there is a next command, and it is time for it.
bool PrintController::give_next(Instant now) {
  const QueuedCommand& next = *commands_.peek();
  // The position is asked for before a layer, and before the user's own lines, which may move
  // anything.
  const auto* ready = std::get_if<firmware_link::ReadyLine>(&next.command);
  const bool unknown = std::holds_alternative<firmware_link::Verbatim>(next.command) ||
                       (ready != nullptr && ready->place == firmware_link::PlaceAfter::kAxesLost);
  if (unchecked_road_ && (next.layer != commands_.last().layer || unknown)) {
    unchecked_road_ = false;
    session().check_position(now);
    return true;
  }
  if (next.pause && pauses_.want_planned(commands_.next())) {
    pause_cause_ = "part";
    reporter_.note(next.pause->event, next.pause->why, {{"layer", next.layer}});
    return true;
  }
  // What a file moves beside its layers is its printer's own affair.
  const firmware_link::Move* move = firmware_link::move_of(next.command);
  const bool looked_at = ready == nullptr || (next.lays_road && next.layer > 0);
  const std::optional<firmware_link::TravelLimits>& limits = session().capabilities().travel;
  if (looked_at && move != nullptr && limits && !within_travel(*move, *limits)) {
    refused_ = fmt::format("layer {} leaves the controller's axes; check bed_x, bed_y and axis_z",
                           next.layer);
    return false;
  }
  firmware_link::Effect effect;
  if (ready != nullptr) effect = ready->effect;
  if (const auto* own = std::get_if<firmware_link::Verbatim>(&next.command)) {
    effect = percent_set_by(own->text());
  }
  take(next, now);
  note_percents(effect, now);
  return true;
}

// A file and the user's lines have factors of their own, which what the user asks for while it
// prints comes on top of: told behind theirs.
void PrintController::note_percents(const firmware_link::Effect& effect, Instant now) {
  const auto percent = static_cast<int>(effect.value);
  if (effect.kind == firmware_link::Effect::Kind::kFeedPercent) {
    feed_.file_set_feed(percent);
    tell_feed(now);
  } else if (effect.kind == firmware_link::Effect::Kind::kFlowPercent) {
    feed_.file_set_flow(percent);
    if (feed_.requested_flow() != 100) session().set_flow_percent(feed_.flow_to_tell(), now);
  }
}

void PrintController::take(const QueuedCommand& queued, Instant now) {
  const bool wanted =
      queued.object == core::kNoObject || !geometry_.signals().objects.is_cancelled(queued.object);
  constexpr std::int64_t kFeedMmMin = 1'200;  // of a move that has nothing else to say
  link_.take(wanted ? queued.command : skipped(queued.command, kFeedMmMin), now);
  unchecked_road_ = unchecked_road_ || queued.lays_road;
  if (queued.layer != commands_.last().layer) reports_.statistics().clock.end_layer();
  commands_.take();
}

void PrintController::keep_journal() {
  const SessionState state = session().state();
  if (state != SessionState::kStreaming && state != SessionState::kFinishing) return;
  if (journal_.keeps()) journal_.keep(account_of(session(), feed_.told_feed()));
}

void PrintController::take_requests(Instant now) {
  while (const std::optional<UserRequest> request = control_.next_request()) obey(*request, now);
  while (const std::optional<int> object = control_.next_cancelled()) cancel_object(*object);
}

void PrintController::obey(UserRequest request, Instant now) {
  switch (request) {
    case UserRequest::kPause:
      pause(true);
      return;
    case UserRequest::kResume:
      session().answer_user(now);
      pause(false);
      return;
    case UserRequest::kToggle:
      pause(!pauses_.pause_wanted());
      return;
    case UserRequest::kStop:
      stop_requested_ = true;
      return;
    case UserRequest::kHelp:
      reporter_.note("keys", key_help());
      return;
    case UserRequest::kObjects:
      reports_.tell_objects();
      return;
    case UserRequest::kFeedUp:
    case UserRequest::kFeedDown:
      feed_.change_feed(request == UserRequest::kFeedUp ? 1 : -1);
      tell_feed(now);
      break;
    case UserRequest::kFlowUp:
    case UserRequest::kFlowDown:
      feed_.change_flow(request == UserRequest::kFlowUp ? 1 : -1);
      if (session().state() == SessionState::kStreaming) {
        session().set_flow_percent(feed_.flow_to_tell(), now);
      }
      break;
  }
  reports_.tell_override(request, feed_);
}

// Once the last one is cancelled, there is nothing left to print.
void PrintController::cancel_object(int number) {
  PrintedObjects& objects = geometry_.signals().objects;
  if (!reports_.tell_cancelled(number, objects.cancel(number - 1))) return;
  const auto count = static_cast<int>(objects.names().size());
  for (int object = 0; object < count; ++object) {
    if (!objects.is_cancelled(object)) return;
  }
  stop_requested_ = true;
}

// A person wants it so.
void PrintController::pause(bool wanted) {
  if (!pauses_.pause_wanted()) pause_cause_ = "user";
  pauses_.want_pause(wanted);
}

// While the print is paused no commands come, which is no stall.
void PrintController::note_phase(Instant now) {
  const PauseControl::Phase phase = pauses_.phase();
  if (phase == PauseControl::Phase::kLeaving) session().hold(true, now);
  if (phase == PauseControl::Phase::kPrinting) session().hold(false, now);
  reports_.tell_pause(phase, pauses_.pause_wanted() ? pause_cause_ : "geometry", options_.hot_s);
}

void PrintController::hear_events() {
  using Kind = firmware_link::SessionEvent::Kind;
  while (const auto event = session().next_event()) {
    reports_.tell_event(*event, session(), started_);
    if (event->kind == Kind::kPauseAsked) pause(true);
    if (event->kind == Kind::kResumeAsked) pause(false);
    if (event->kind == Kind::kCancelAsked) stop_requested_ = true;
  }
}

void PrintController::watch_underrun(Instant now) {
  const CommandQueue& queue = commands_.queue();
  UnderrunWatch::Sight sight;
  sight.streaming = session().state() == SessionState::kStreaming;
  sight.road_given = commands_.road_given();
  sight.all_given = all_given_;
  sight.command_waits = commands_.peek() != nullptr;
  sight.more_to_come = !queue.finished();
  sight.queue_half_full = queue.level().items >= queue.limits().items / 2;
  sight.planner_blocks = session().planner_blocks();
  sight.ahead_s = geometry_.seconds_made() - commands_.last().seconds;
  sight.printing = pauses_.printing();
  sight.parked = pauses_.underrun();
  const UnderrunWatch::Action action = underrun_.look(steady_seconds(), sight);
  LinkStatistics& statistics = reports_.statistics();
  if (action != UnderrunWatch::Action::kNone) {
    const bool parks = action == UnderrunWatch::Action::kPark;
    if (parks) ++statistics.parks;
    pauses_.set_underrun(parks);
    return;
  }
  const int percent = underrun_.feed_percent();
  if (percent == feed_.throttle()) return;
  if (percent < feed_.throttle()) ++statistics.slowdowns;
  statistics.feed_percent = percent;
  feed_.set_throttle(percent);
  tell_feed(now);
}

void PrintController::tell_feed(Instant now) {
  if (session().state() != SessionState::kStreaming) return;
  if (const std::optional<int> percent = feed_.feed_to_tell()) {
    session().set_feed_percent(*percent, now);
  }
}

bool PrintController::recoverable() {
  const FaultKind kind = session().fault_kind();
  return options_.lost_port_wait_s > 0 && recovery_.possible() &&
         (kind == FaultKind::kReset || kind == FaultKind::kPortLost);
}

// Waits for the controller, and has the print resumed. An outcome when that did not succeed.
std::optional<LinkOutcome> PrintController::recover() {
  const bool reset = session().fault_kind() == FaultKind::kReset;
  const std::optional<JournalRecord> left = journal_.record(
      reset ? PrintState::kReset : PrintState::kPortLost, account_of(session(), feed_.told_feed()));
  if (!left) return ending_.faulted();
  journal_.close(*left);
  LinkOutcome end = ending_.outcome(LinkEnd::kFaulted);
  end.reason = session().reason();
  const double fault_s = steady_seconds();
  reports_.tell_fault(end.reason, reset, options_.lost_port_wait_s);
  reports_.start_session();
  if (const auto ended = reconnect(reset, fault_s + options_.lost_port_wait_s)) {
    if (ended->end == LinkEnd::kFaulted) end.reason += "; " + ended->reason;
    if (ended->end != LinkEnd::kFaulted) end.reason = ended->reason;
    end.end = ended->end;
    end.measures = ended->measures;
    return end;
  }
  if (const auto failure = recovery_.resume_after_fault(*left, fault_s)) {
    if (!failure->reason.empty()) end.reason += "; " + failure->reason;
    end.measures = failure->measures;
    return end;
  }
  ++reports_.statistics().recoveries;
  all_given_ = unchecked_road_ = false;
  feed_.start_session();
  return std::nullopt;
}

// A new session over the port that came back. An outcome when none came about in time.
std::optional<LinkOutcome> PrintController::reconnect(bool reset, double until_s) {
  bool open = reset && link_.port_open();
  while (true) {
    if (stop_asked()) return ending_.stop_waiting(LinkEnd::kUserStopped);
    if (geometry_.queue().closed()) return ending_.stop_waiting(LinkEnd::kGeometryEnded);
    if (steady_seconds() > until_s) return ending_.stop_waiting(LinkEnd::kFaulted);
    take_requests(link_now());
    reports_.show_progress(session());
    if (!open && !link_.reopen_port(control_)) {
      std::this_thread::sleep_for(kReopenPause);
      continue;
    }
    link_.start_session(true);
    while (session().state() == SessionState::kConnecting && !stop_asked() &&
           steady_seconds() <= until_s) {
      link_.step(link_now());
      hear_events();
    }
    if (session().state() == SessionState::kStreaming) return std::nullopt;
    open = link_.port_open();
  }
}

}  // namespace host
