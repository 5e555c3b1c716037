#include "host/printing/monitor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "core/check.h"
#include "firmware_link/dialects/marlin_dialect.h"
#include "firmware_link/session/link_step.h"
#include "host/printing/port_clock.h"

namespace host {
namespace {

using firmware_link::Instant;
using firmware_link::SessionState;

// How long one turn waits for an answer. Short, because a command that geometry has just put into
// an empty queue waits as long.
constexpr int kWait_ms = 5;
constexpr int kTravelAsks = 2;
constexpr int kFeedPercentMin = 10;
constexpr int kFeedPercentMax = 500;

}  // namespace

Monitor::Monitor(const PrintSettings& settings, MonitorOptions options,
                 firmware_link::BytePort& port, CommandQueue& queue, Reporter& reporter)
    : settings_(settings),
      options_(std::move(options)),
      port_(&port),
      queue_(queue),
      reporter_(reporter),
      machine_(with_space(settings, options_.space.value_or(space_of(settings)))),
      park_moves_(machine_, parking_place(machine_, options_.part)),
      pauses_(park_moves_, options_.hot_s),
      starting_(options_.resumption.has_value()) {
  RIND_CHECK(options_.stop_count != nullptr);
  RIND_CHECK(options_.slices_cut != nullptr);
  RIND_CHECK(options_.layers != nullptr);
  RIND_CHECK(options_.warnings != nullptr);
  begin_session(starting_);
}

void Monitor::begin_session(bool ask_found_line) {
  firmware_link::SessionOptions options;
  options.ask_found_line = ask_found_line;
  options.pack = settings_.meatpack == PackUse::kAuto;
  options.wait_limit = firmware_link::Duration(std::llround(settings_.wait_limit_s * 1e6));
  options.banner_wait = firmware_link::Duration(std::llround(options_.banner_wait_s * 1e6));
  session_ = std::make_unique<firmware_link::Session>(
      std::make_unique<firmware_link::MarlinDialect>(), options, link_now());
}

LinkOutcome Monitor::run() {
  statistics_.clock.enter(Stage::kSend);
  while (true) {
    if (stop_asked()) return stop(LinkEnd::kUserStopped);
    if (queue_.closed()) return stop(LinkEnd::kGeometryEnded);
    const Instant now = link_now();
    take_requests(now);
    watch_queue(now);
    feed(now);
    if (!refused_.empty()) return stop(LinkEnd::kRefused);
    if (!unplaced_.empty()) return unplaced();
    keep_journal();
    firmware_link::step(*session_, *port_, now, kWait_ms);
    note_acknowledged();
    tell_events();
    report_progress();
    if (session_->state() == SessionState::kFinished) return done();
    if (session_->state() != SessionState::kFaulted) continue;
    if (!recoverable()) return faulted();
    if (const std::optional<LinkOutcome> end = recover()) return *end;
  }
}

// Whether the controller has had its chance to tell how far its axes go. Twice, because an answer
// may be damaged.
bool Monitor::travel_asked(Instant now) {
  const std::string question(session_->rules().travel_question);
  if (question.empty()) return true;
  while (travel_asks_ < kTravelAsks && session_->can_take()) {
    session_->insert(command_of(question), now);
    ++travel_asks_;
  }
  return travel_asks_ == kTravelAsks && session_->can_take() &&
         session_->statistics().lines_in_flight == 0;
}

// What the controller tells of its axes is believed.
core::Status Monitor::check_space() {
  MachineSpace space = options_.space.value_or(space_of(settings_));
  std::optional<firmware_link::TravelLimits> limits = session_->capabilities().travel;
  if (limits) {
    const core::Status fits =
        check_travel(on_machine(options_.part, settings_), options_.height, *limits);
    if (!fits.ok()) return fits;
    limits = from_bed(*limits, settings_);
  }
  if (const std::string note = space_note(space, limits); !note.empty()) {
    reporter_.note("bed", note);
  }
  if (!limits) return {};
  space = within(space, *limits);
  machine_ = with_space(settings_, space);
  park_moves_ = ParkMoves(machine_, parking_place(machine_, options_.part));
  pauses_.set_park_moves(park_moves_);
  return {};
}

// Once, when the controller has said what it can do: whether the print may begin.
bool Monitor::begun(Instant now) {
  if (begun_) return true;
  if (session_->state() != SessionState::kStreaming || !travel_asked(now)) return false;
  begun_ = true;
  core::Status may = check_space();
  if (may.ok() && options_.may_begin) may = options_.may_begin();
  if (!may.ok()) {
    refused_ = may.error().message;
    return false;
  }
  if (options_.controller_known) options_.controller_known(session_->capabilities());
  return true;
}

void Monitor::feed(Instant now) {
  if (!begun(now)) return;
  while (session_->can_take() && feed_one(now)) {
  }
  if (!finish_said_ && session_->state() == SessionState::kStreaming && !starting_ &&
      pauses_.printing() && peek() == nullptr && queue_.drained() && !queue_.closed()) {
    session_->finish(now);
    finish_said_ = true;
  }
}

// False when there is nothing to give at the moment. REQUIRES: the session can take a command.
bool Monitor::feed_one(Instant now) {
  if (const std::optional<firmware_link::Command> command = pauses_.next()) {
    given_ = true;
    session_->insert(*command, now);
    return true;
  }
  if (pauses_.turn_due() && pauses_.turn(steady_seconds(), history_.state_before(index_))) {
    tell_phase(now);
    return true;
  }
  if (!pauses_.printing()) return false;
  if (starting_ && !start_resumed()) return false;
  const QueuedCommand* next = peek();
  if (next == nullptr) return false;
  if (index_ < skip_until_) {
    last_ = *next;
    advance();
    return true;
  }
  if (go_on_at_) {
    const ResumePoint point = *std::exchange(go_on_at_, std::nullopt);
    const std::int64_t z_um = options_.resumption->nozzle_z_um;
    pauses_.go(way_back(point, z_um, false), z_um);
    session_->hold(true, now);
    return true;
  }
  // Before a layer, and before the user's own lines, which may move anything.
  const bool unknown = std::holds_alternative<firmware_link::Verbatim>(next->command);
  if (unchecked_road_ && (next->layer != last_.layer || unknown)) {
    unchecked_road_ = false;
    session_->check_position(now);
    return true;
  }
  if (next->pause && paused_before_ != index_) {
    paused_before_ = index_;
    pause_cause_ = "part";
    reporter_.note("bad_layer",
                   *next->pause + "; going on prints what could be repaired, else stop",
                   {{"layer", next->layer}});
    pauses_.want_pause(true);
    return true;
  }
  const auto* move = std::get_if<firmware_link::Move>(&next->command);
  const std::optional<firmware_link::TravelLimits>& limits = session_->capabilities().travel;
  if (move != nullptr && limits && !within_travel(*move, *limits)) {
    refused_ = fmt::format("layer {} leaves the controller's axes; check bed_x, bed_y and axis_z",
                           next->layer);
    return false;
  }
  take(*next, now);
  return true;
}

// What was given to a session that is lost, and has to be given again, then what is new.
const QueuedCommand* Monitor::peek() {
  if (index_ < history_.end()) return &history_.at(index_);
  if (!waiting_) waiting_ = queue_.try_pop();
  return waiting_ ? &*waiting_ : nullptr;
}

void Monitor::advance() {
  if (index_ == history_.end()) history_.push(*std::exchange(waiting_, std::nullopt));
  ++index_;
}

void Monitor::take(const QueuedCommand& queued, Instant now) {
  session_->take(queued.command, now);
  given_ = true;
  unchecked_road_ = unchecked_road_ || queued.lays_road;
  if (queued.lays_road && first_road_ == 0) first_road_ = index_ + 1;
  if (queued.layer != last_.layer) statistics_.clock.end_layer();
  last_ = queued;
  advance();
}

// Whether geometry keeps up: slower first, then off the part.
void Monitor::watch_queue(Instant now) {
  const bool empty = peek() == nullptr;
  const double now_s = steady_seconds();
  const bool idle = empty && !finish_said_ && first_road_ > 0 && session_->planner_blocks() <= 1;
  if (!idle) {
    idle_since_s_.reset();
  } else if (!idle_since_s_) {
    idle_since_s_ = now_s;
  }
  if (options_.underrun_s <= 0 || !options_.seconds_made) return;
  const bool more = !queue_.finished();
  const double ahead_s = options_.seconds_made() - last_.seconds;
  if (pauses_.underrun()) {
    const bool enough =
        ahead_s >= FeedThrottle::kAmple_s || queue_.level().items >= queue_.limits().items / 2;
    if (enough || !more) pauses_.set_underrun(false);
    return;
  }
  if (first_road_ == 0 || session_->state() != SessionState::kStreaming) return;
  if (more && pauses_.printing() && idle_since_s_ &&
      now_s - *idle_since_s_ >= options_.underrun_s) {
    ++statistics_.parks;
    pauses_.set_underrun(true);
    return;
  }
  const int wanted = throttle_.percent(now_s, ahead_s, more);
  if (wanted == statistics_.feed_percent) return;
  if (wanted < statistics_.feed_percent) ++statistics_.slowdowns;
  statistics_.feed_percent = wanted;
  set_feed(now);
}

// What a person wants, times what geometry can follow.
void Monitor::set_feed(Instant now) {
  const int percent = std::clamp(requested_feed_percent_ * statistics_.feed_percent / 100,
                                 kFeedPercentMin, kFeedPercentMax);
  if (percent == feed_percent_ || session_->state() != SessionState::kStreaming) return;
  feed_percent_ = percent;
  session_->set_feed_percent(percent, now);
}

}  // namespace host
