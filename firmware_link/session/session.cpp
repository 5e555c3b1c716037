#include "firmware_link/session/session.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

#include "firmware_link/wire/check.h"
#include "firmware_link/wire/meat_pack.h"  // kMeatPackReset
#include "firmware_link/wire/quotes.h"     // in_quotes

namespace firmware_link {
Session::Session(std::unique_ptr<Dialect> dialect, const SessionOptions& options, Instant now)
    : options_(options),
      stop_(now),
      signs_(now),
      recovery_(now),
      silence_(options.wait_limit),
      identity_(std::move(dialect)),
      greeting_(now) {
  LINK_CHECK(options_.line_number_max >= 1 && options_.line_number_max <= kLineNumberMax);
  requests_.start(now);
}

// --- what it tells ---

std::int32_t Session::accepted_line() const {
  return static_cast<std::int32_t>(
      std::max<std::int64_t>(0, window_.number_of(window_.acknowledged()) - 1));
}

std::optional<std::int64_t> Session::commands_through_line(std::int32_t line) const {
  const std::int64_t sequence = window_.sequence_of(line) + 1;
  if (sequence < window_.oldest() || sequence > window_.end()) return std::nullopt;
  return window_.commands_before(sequence);
}

SessionStatistics Session::statistics() const {
  SessionStatistics now = statistics_;
  now.commands_sent = window_.commands_before(window_.sent_end());
  now.commands_acknowledged = accepted();
  now.events_dropped = events_.dropped();
  now.planner_low_s = std::chrono::duration<double>(planner_.low()).count();
  now.lines_in_flight = window_.lines_in_flight();
  now.bytes_in_flight = window_.bytes_in_flight();
  now.replies_cut = splitter_.lines_cut();
  now.temperatures = temperatures_.known();
  return now;
}

bool Session::ended() const {
  return state_ == SessionState::kFaulted || state_ == SessionState::kFinished ||
         state_ == SessionState::kStopped;
}

// --- requests of the host ---

bool Session::can_take() const {
  return state_ == SessionState::kStreaming && window_.all_sent() && !own_line_due() &&
         !position_.confirming() && !deferred_ && !shutdown_.awaited();
}

void Session::take(const Command& command, Instant now) { give(command, true, now); }

void Session::insert(const Command& command, Instant now) { give(command, false, now); }

void Session::give(const Command& command, bool is_command, Instant now) {
  LINK_CHECK(can_take());
  if (is_command) ++statistics_.commands_taken;
  const Move* move = move_of(command);
  const bool counts = options_.count_filament && move != nullptr && move->e_10nm;
  if (rules().tells_position && counts && !position_.watch().expected().e_10nm) {
    // From here on the controller's count of filament is to be known. Not earlier, because the
    // user's own lines may count in their own way.
    requests_.reset_filament();
    deferred_ = {command, is_command};
  } else {
    push_command(command, is_command);
  }
  pump(now);
}

void Session::finish(Instant now) {
  LINK_CHECK(state_ == SessionState::kStreaming);
  state_ = SessionState::kFinishing;
  settle(now);
}

void Session::hold(bool holding, Instant now) {
  requests_.hold(holding);
  planner_.expect_gap(now);
}

void Session::set_feed_percent(int percent, Instant now) {
  LINK_CHECK(percent >= 10 && percent <= 500);
  requests_.set_feed_percent(percent);
  pump(now);
}

void Session::set_flow_percent(int percent, Instant now) {
  LINK_CHECK(percent >= 10 && percent <= 500);
  requests_.set_flow_percent(percent);
  pump(now);
}

void Session::check_position(Instant now) {
  if (!rules().tells_position || state_ != SessionState::kStreaming) return;
  requests_.ask_position();
  pump(now);
}

void Session::answer_user(Instant now) {
  if (!silence_.user_awaited() || !rules().numbered || phase_ != Phase::kOpen) return;
  put_wait_no_more();
  silence_.await_user(false);
  signs_.expect_sense(now);
}

void Session::stop_now(std::span<const Command> safe_sequence, Instant now) {
  if (state_ == SessionState::kStopping || state_ == SessionState::kStopped) return;
  stop_.set_sequence(safe_sequence);
  requests_.drop();
  deferred_.reset();
  position_.drop();
  if (state_ == SessionState::kConnecting || state_ == SessionState::kFaulted) {
    if (fault_.controller_may_live) {
      if (packing_.may_unpack()) output_.put(kMeatPackReset);
      stop_.put_plain(output_);
      stop_.listen();
    }
    if (state_ == SessionState::kConnecting) state_ = SessionState::kStopped;
    return;
  }
  state_ = SessionState::kStopping;
  stop_.start(command_that_waits(), now);
  window_.drop_never_sent();
  // What waits for heat or for a user waits no longer; its own `ok` is met by the forced mismatch.
  if (rules().numbered && window_.lone_line_in_flight()) put_wait_no_more();
  // Which of the sent lines are accepted decides where the safe sequence starts: a line with a
  // number that the controller already has would be dropped in silence.
  if (!rules().numbered) {
    stop_.starts_at(window_.end());
  } else if (phase_ == Phase::kOpen) {
    resynchronise(now);
  }
  pump(now);
}

// The command at hand as a stop starts, where it may take long by nature, whatever was lost of its
// answers: a G28 that probes, in silence.
std::optional<std::string> Session::command_that_waits() const {
  if (!window_.lone_line_in_flight()) return std::nullopt;
  // A question may stand behind it.
  std::int64_t at = window_.acknowledged();
  while (at + 1 < window_.next_to_send() && !wait_of(window_.text(at), rules().macros).is_long()) {
    ++at;
  }
  const std::string_view text = window_.text(at);
  return std::string(text.substr(0, text.find(' ')));
}

void Session::port_lost(const std::string& reason) {
  if (!ended()) fault(FaultKind::kPortLost, reason, false);
}

// --- bytes out, time ---

void Session::written(std::size_t count, Instant now) {
  bridge_gap(now);
  output_.written(count);
  statistics_.bytes_sent += static_cast<std::int64_t>(count);
  // Quiet counts from when the last byte left, so that its answer can come.
  if (output_.empty() && count > 0) recovery_.bytes_left(now);
}

// A host that stood still holds nothing against the controller.
void Session::bridge_gap(Instant now) {
  const Duration gap = signs_.turn(now);
  if (gap.count() == 0) return;
  stop_.bridge(gap, now);
  greeting_.bridge(gap, now);
  readiness_.bridge(gap, now);
  shutdown_.bridge(gap, now);
  recovery_.bridge(gap, now);
  silence_.bridge(gap, now);
  packing_.bridge(gap, now);
}

void Session::tick(Instant now) {
  bridge_gap(now);
  if (ended()) return;
  if (shutdown_.awaited()) {
    tick_shut_down(now);
    return;
  }
  planner_.advance(now);
  if (phase_ == Phase::kReadying) {
    tick_readying(now);
  } else if (phase_ == Phase::kAsking || phase_ == Phase::kOpen) {
    tick_open(now);
  } else {
    tick_greeting(now);
  }
  if (state_ == SessionState::kStopping) tick_stop(now);
  settle(now);
  pump(now);
}

void Session::tick_open(Instant now) {
  if (recovery_.quiet_over(rules().quiet_after_resend, output_.empty(), now)) {
    if (packing_.may_unpack()) packing_.stop(packing_sight(), output_);
    signs_.expect_answer(now);
  }
  tick_asking(now);
  packing_.tick(packing_sight(), now, output_);
  tick_silence(now);
  if (phase_ != Phase::kOpen || state_ != SessionState::kStreaming) return;
  requests_.tick({options_.temperature_interval, identity_.capabilities().autoreport_temperatures,
                  rules().keep_awake, window_.lines_in_flight() > 0, signs_.byte()},
                 now);
}

void Session::tick_greeting(Instant now) {
  switch (greeting_.look(phase_, options_, signs_, now)) {
    case Greeting::Step::kWait:
      return;
    case Greeting::Step::kGreetLate:
      events_.push(SessionEvent::Kind::kWaits, "an answer to the greeting");
      greet(now);
      return;
    case Greeting::Step::kGreet:
      greet(now);
      return;
    case Greeting::Step::kSettled:
      start_readying(now);
      return;
    case Greeting::Step::kGiveUp: {
      std::string why = greeting_.reason();
      const std::string& refusal = complaints_.last_refusal();
      if (!refusal.empty()) why += " It said " + in_quotes(refusal);
      fault(FaultKind::kNoAnswer, why, true);
      return;
    }
  }
}

void Session::greet(Instant now) {
  greeting_.put(phase_, options_, now, output_);
  recovery_.greeting_sent();
  phase_ = Phase::kGreeting;
}

void Session::restart_conversation() {
  window_.restart(window_.oldest());
  window_.drop_unsent();
  recovery_.restart();
  identity_.ask_again();
}

void Session::tick_asking(Instant now) {
  if (phase_ != Phase::kAsking || silence_.works() || !greeting_.name_overdue(now)) return;
  restart_conversation();
  if (greeting_.may_greet_again(options_)) {
    greet(now);
  } else {
    fault(FaultKind::kNoAnswer, "the controller answers, but does not say what it is", true);
  }
}

void Session::start_readying(Instant now) {
  if (dialect().state_question().empty()) {
    open(now);
    return;
  }
  phase_ = Phase::kReadying;
  readiness_.start(now);
  ask_whether_ready(now);
}

void Session::ask_whether_ready(Instant now) {
  readiness_.asks();
  signs_.expect_progress(now);
  push_own(readiness_.question(dialect()));
}

void Session::tick_readying(Instant now) {
  const Readiness::Step step = readiness_.tick(options_.ready_wait, now);
  const bool late = window_.lines_in_flight() > 0 && now - signs_.progress() > rules().ask_after;
  if (late && step != Readiness::Step::kFault) ask_for_answer(now);
  go_on_readying(step, now);
}

void Session::go_on_readying(Readiness::Step step, Instant now) {
  switch (step) {
    case Readiness::Step::kWait:
      return;
    case Readiness::Step::kAsk:
      ask_whether_ready(now);
      return;
    case Readiness::Step::kReady:
      open(now);
      return;
    case Readiness::Step::kNotReady:
      events_.push(SessionEvent::Kind::kNotReady, readiness_.words());
      return;
    case Readiness::Step::kFault:
      halted(readiness_.reason());
      return;
  }
}

void Session::open(Instant now) {
  phase_ = Phase::kOpen;
  state_ = SessionState::kStreaming;
  signs_.expect_answer(now);
  requests_.start(now);
  const Duration interval = options_.temperature_interval;
  if (interval.count() > 0 && identity_.capabilities().autoreport_temperatures) {
    requests_.report_temperatures(interval);
  }
}

void Session::tick_shut_down(Instant now) {
  if (!shutdown_.over(window_.lines_in_flight() > 0, now)) return;
  if (shutdown_.is_shut_down()) {
    halted("the controller has shut down: " + in_quotes(shutdown_.words()));
  } else {
    fault(FaultKind::kAlarm, "the controller refused a command: " + in_quotes(shutdown_.words()),
          true);
  }
}

void Session::tick_silence(Instant now) {
  if (ended() || (window_.lines_in_flight() == 0 && !recovery_.asked())) {
    silence_.over();
    return;
  }
  const SilenceWatch::Sight sight = silence_sight(now);
  const SilenceWatch::Step step = silence_.look(rules(), sight, now);
  if (silence_.tells_wait(sight, now)) {
    events_.push(SessionEvent::Kind::kWaits, SilenceWatch::what_of(sight));
  }
  switch (step) {
    case SilenceWatch::Step::kWait:
      return;
    case SilenceWatch::Step::kAsk:
      ask(sight, now);
      return;
    case SilenceWatch::Step::kResynchronise:
      ++statistics_.resyncs;
      resynchronise(now);
      return;
    case SilenceWatch::Step::kGiveUp: {
      std::string why = silence_.reason();
      const std::string& refusal = complaints_.last_refusal();
      if (!refusal.empty()) why += "; its last complaint was " + in_quotes(refusal);
      fault(FaultKind::kSilence, why, true);
      return;
    }
  }
}

void Session::tick_stop(Instant now) {
  stop_.acknowledged(window_.acknowledged(), now);
  if (stop_.tells_wait(silence_.works(), now)) {
    events_.push(SessionEvent::Kind::kStopWaits, stop_.behind().value_or(""));
  }
  const auto taken = stop_.overdue(options_, silence_.works(), planner_.end(), now);
  if (!taken) return;
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(*taken).count();
  fault(FaultKind::kStop,
        "the controller did not acknowledge the stop within " + std::to_string(seconds) + " s",
        true);
}

// --- ends ---

void Session::warn(std::string_view words) {
  ++statistics_.warnings;
  events_.push(SessionEvent::Kind::kWarning, std::string(words));
}

void Session::halted(const std::string& why) {
  const std::string_view remedy = dialect().remedy();
  fault(FaultKind::kHalted, remedy.empty() ? why : why + "; " + std::string(remedy), false);
}

void Session::fault(FaultKind kind, const std::string& why, bool controller_may_live) {
  state_ = SessionState::kFaulted;
  fault_ = {kind, why, controller_may_live};
  output_.clear();
}

}  // namespace firmware_link
