// The half of the session that listens: what each answer means for the order of lines.
#include <algorithm>
#include <string>

#include "firmware_link/session/session.h"
#include "firmware_link/wire/check.h"
#include "firmware_link/wire/meat_pack.h"  // kMeatPackAnswer
#include "firmware_link/wire/quotes.h"     // in_quotes

namespace firmware_link {
namespace {

// An `ok` too many uncovers itself by a request for a line that was acknowledged. So many of them
// in a row are something else.
constexpr std::int64_t kFalseAnswersMax = 8;

}  // namespace

void Session::input(std::span<const std::byte> bytes, Instant now) {
  bridge_gap(now);
  if (!bytes.empty()) signs_.bytes_heard(now);
  while (!bytes.empty() && (stop_.listens() || !ended())) {
    bytes = bytes.subspan(splitter_.take(bytes));
    const auto line = splitter_.line();
    if (!line) continue;
    if (stop_.listens()) {
      stop_.told(read_reply(*line).temperatures);
    } else {
      reply(read_reply(*line), now);
    }
  }
  if (ended()) return;
  settle(now);
  pump(now);
}

void Session::reply(const Reply& reply, Instant now) {
  const Meaning meaning = dialect().meaning_of(reply);
  signs_.heard(reply, meaning, now);
  if (meaning == Meaning::kWorking) silence_.worked();
  if (meaning == Meaning::kAcknowledge) silence_.answered();
  if (reply.text.substr(0, kMeatPackAnswer.size()) == kMeatPackAnswer) packing_.heard(reply.text);
  note_temperatures(reply.temperatures, now);
  if (ended()) return;
  identity_.heard(reply);
  if (reply.kind == Reply::Kind::kAction) {
    events_.push(kind_of_action(reply.text), std::string(reply.text));
  }
  if (reply.kind == Reply::Kind::kBusy &&
      reply.text.find("paused for user") != std::string_view::npos && !silence_.user_awaited()) {
    silence_.await_user(true);
    events_.push(SessionEvent::Kind::kWaitsForUser, std::string(reply.text));
  }
  if (reply.kind == Reply::Kind::kPosition) note_position(reply.position, now);
  if (ended() || reply_ends(reply, meaning, now)) return;
  if (phase_ == Phase::kAsking || phase_ == Phase::kOpen) {
    reply_while_open(reply, meaning, now);
  } else {
    reply_while_connecting(reply, meaning, now);
  }
}

// True when it was about the end of the conversation, or of the controller.
bool Session::reply_ends(const Reply& reply, Meaning meaning, Instant now) {
  if (shutdown_.is_shut_down()) {
    if (reply.kind == Reply::Kind::kAlarm) {
      halted("the controller has shut down: " + in_quotes(reply.text));
    }
    return true;
  }
  // One that has just said its name may not be ready; one that has not may be Klipper, which
  // answers with alarms until it is.
  if (phase_ != Phase::kOpen && reply.kind == Reply::Kind::kAlarm) {
    complaints_.refused(reply.text);
    if (phase_ == Phase::kReadying) reply_while_readying(reply, meaning, now);
    return true;
  }
  if (meaning == Meaning::kShutDown && phase_ == Phase::kOpen) {
    shut_down_seen(reply.text, now);
    return true;
  }
  if (meaning == Meaning::kFatal) {
    halted("the controller stopped: " + in_quotes(reply.text));
    return true;
  }
  if (meaning == Meaning::kAlarm && dialect().lost_its_position(reply.text)) {
    if (shutdown_.position_lost(reply.text, now)) output_.clear();
    return true;
  }
  if (shutdown_.is_lost() && meaning != Meaning::kReset) return true;
  if (meaning == Meaning::kAlarm) {
    fault(FaultKind::kAlarm, "the controller refused a command: " + in_quotes(reply.text), true);
    return true;
  }
  if (meaning == Meaning::kReset) reset_seen(now);
  return meaning == Meaning::kReset;
}

void Session::reply_while_connecting(const Reply& reply, Meaning meaning, Instant now) {
  if (phase_ == Phase::kReadying) {
    reply_while_readying(reply, meaning, now);
    return;
  }
  if (phase_ != Phase::kGreeting) return;
  if (meaning == Meaning::kResend || meaning == Meaning::kRefused) complaints_.refused(reply.text);
  if (greeting_.accepted_by(reply, meaning)) greeted(now);
}

void Session::reply_while_readying(const Reply& reply, Meaning meaning, Instant now) {
  readiness_.heard(reply, dialect(), identity_.capabilities());
  if (meaning != Meaning::kAcknowledge) return;
  if (answers_question(reply)) {
    // What it said before may have been lost with its `ok`: the same is asked again.
    const auto through = questions_.answered(window_);
    if (through && OrderedQuestions::acknowledge_through(window_, *through)) {
      ask_whether_ready(now);
    }
  } else if (window_.acknowledge_one()) {
    go_on_readying(readiness_.answered(dialect(), options_.ask_found_line, now), now);
  }
}

void Session::reply_while_open(const Reply& reply, Meaning meaning, Instant now) {
  // Nothing comes between a refusal and its `ok`; a line that does means that the `ok` got lost.
  if (meaning != Meaning::kAcknowledge && meaning != Meaning::kResend) recovery_.other_heard();
  const bool repeats = meaning == Meaning::kResend || meaning == Meaning::kRefused;
  if (repeats && complaints_.mended()) ++statistics_.fragments;
  switch (meaning) {
    case Meaning::kAcknowledge:
      if (const auto words = complaints_.stands()) warn(*words);
      acknowledged(reply, now);
      break;
    case Meaning::kResend:
      resend_asked(reply, now);
      break;
    case Meaning::kRefused:
      recovery_.refused(reply.text, now);
      complaints_.refused(reply.text);
      break;
    case Meaning::kWarning:
      complaint_heard(reply);
      break;
    case Meaning::kFilamentHeld:
      // It counts the filament all the same, so M114 does not show it. Before the count starts, it
      // is the user's own start G-code that retracts cold.
      if (position_.watch().expected().e_10nm && state_ == SessionState::kStreaming) {
        fault(FaultKind::kAlarm, "the controller refused to lay: " + in_quotes(reply.text), true);
      } else {
        warn(reply.text);
      }
      break;
    case Meaning::kWorking:
      recovery_.work_seen();
      break;
    case Meaning::kNoise:
    case Meaning::kAlive:
    case Meaning::kShutDown:  // while it is not open
      break;
    case Meaning::kReset:
    case Meaning::kAlarm:
    case Meaning::kFatal:
      LINK_CHECK(false);
  }
}

// Line numbers have started again; what is sent next is N1.
void Session::greeted(Instant now) {
  window_.forget_acknowledged();
  window_.restart_numbers();
  recovery_.numbers_restarted();
  signs_.expect_answer(now);
  if (state_ == SessionState::kConnecting) {
    phase_ = Phase::kAsking;
    greeting_.next_phase(now);
    push_own("M115");
  } else {
    phase_ = Phase::kOpen;
  }
}

void Session::reset_seen(Instant now) {
  if (state_ != SessionState::kConnecting) {
    fault(FaultKind::kReset,
          "the controller was reset in mid-print, and has forgotten its position", false);
  } else if (!greeting_.started(now)) {
    fault(FaultKind::kNoAnswer,
          "the controller resets itself again and again: is its power supply right?", false);
  } else {
    phase_ = Phase::kBanner;
    restart_conversation();
  }
}

// The print is over; nothing more is sent but the question why.
void Session::shut_down_seen(std::string_view words, Instant now) {
  if (!shutdown_.shut_down(words, now)) return;
  output_.clear();
  const std::string_view question = dialect().state_question();
  if (question.empty()) return;
  output_.put("\n");
  output_.put(question);
  output_.put("\n");
}

void Session::complaint_heard(const Reply& reply) {
  const bool unchecked = phase_ == Phase::kOpen && rules().macros && !rules().numbered;
  if (unchecked && quotes_what_was_not_sent(reply.text, window_)) {
    fault(FaultKind::kPosition,
          "a line was damaged on its way to the controller, which says " + in_quotes(reply.text),
          true);
    return;
  }
  switch (complaints_.heard(reply, window_, rules().numbered)) {
    case Complaints::Fate::kTell:
      warn(reply.text);
      break;
    case Complaints::Fate::kCount:
      ++statistics_.fragments;
      break;
    case Complaints::Fate::kHold:
      break;
  }
  if (phase_ == Phase::kAsking) identity_.name_refused();
}

void Session::note_temperatures(const Temperatures& told, Instant now) {
  temperatures_.told(told);
  if (state_ != SessionState::kStreaming && state_ != SessionState::kFinishing) return;
  if (silence_.user_awaited()) return temperatures_.restart();
  if (const auto words = temperatures_.complaint(told, now)) {
    fault(FaultKind::kHeater, *words, true);
  }
}

void Session::note_position(const Position& told, Instant now) {
  position_.told(told);
  const auto question = position_.in_flight();
  if (!question || rules().numbered) return;
  // What was asked is answered in its turn, so all before it has been.
  if (*question <= window_.acknowledged() || *question >= window_.next_to_send()) return;
  const std::int64_t before = window_.acknowledged();
  acknowledge_through(*question - 1);
  note_accepted(before, now);
}

void Session::acknowledged(const Reply& reply, Instant now) {
  silence_.await_user(false);
  if (recovery_.skips_ok(now)) return;
  // An `ok` before the answer to M115 is to a line of a host before us.
  if (phase_ == Phase::kAsking && !identity_.name_told()) {
    ++statistics_.stray_acknowledgements;
    return;
  }
  recovery_.ok_heard();
  const std::int64_t before = window_.acknowledged();
  const bool ours = acknowledge(reply);
  if (ended()) return;
  if (!ours) {
    ++statistics_.stray_acknowledgements;
    return;
  }
  recovery_.account_possible();
  note_accepted(before, now);
  if (reply.planner_free) planner_.told_free(*reply.planner_free, now);
  if (state_ == SessionState::kStreaming && !requests_.holding() && phase_ == Phase::kOpen &&
      window_.all_sent() && window_.lines_in_flight() == 0) {
    ++statistics_.stalls;
  }
}

// True when the `ok` is one to a line in flight: the one that it numbers (ADVANCED_OK), the
// question that it answers, or the oldest.
bool Session::acknowledge(const Reply& reply) {
  if (reply.number && rules().numbered) {
    // Bounded before the sum, because any number may come.
    const std::int64_t number = std::clamp<std::int64_t>(*reply.number, 0, kResyncLineNumber);
    const std::int64_t sequence = window_.sequence_of(number);
    const bool ours = sequence >= window_.acknowledged() && sequence < window_.next_to_send();
    if (ours) window_.acknowledge_before(sequence + 1);
    return ours;
  }
  if (answers_question(reply)) {
    const auto through = questions_.answered(window_);
    if (through) acknowledge_through(*through);
    return through.has_value();
  }
  questions_.plain_ok_heard();
  return window_.acknowledge_one();
}

// Whether an `ok` can be told from others: to a question, or late to one.
bool Session::answers_question(const Reply& reply) const {
  const bool warm = reply.temperatures.nozzle_celsius || reply.temperatures.bed_celsius;
  return warm && (OrderedQuestions::in_flight(window_) > 0 || !rules().numbered);
}

// All up to that line have been answered, whatever was heard of it.
void Session::acknowledge_through(std::int64_t sequence) {
  const bool missing = OrderedQuestions::acknowledge_through(window_, sequence);
  if (!missing || rules().numbered) return;
  if (state_ != SessionState::kStreaming && state_ != SessionState::kFinishing) return;
  if (rules().checksummed) {
    fault(FaultKind::kSilence,
          "the controller left a line without an answer: nobody can know whether it ran", true);
    return;
  }
  // The answer was lost, or the line itself; where the nozzle is, and how much filament it has
  // pushed, tells which.
  requests_.ask_position();
}

// What it means that lines from `from` on have been acknowledged.
void Session::note_accepted(std::int64_t from, Instant now) {
  for (std::int64_t i = from; i < window_.acknowledged(); ++i) {
    const LineEffort& effort = window_.effort(i);
    if (effort.empties_planner) planner_.expect_gap(now);
    if (effort.nominal.count() > 0) planner_.accepted_move(effort.nominal, now, effort.blocks);
  }
  settle_position();
}

void Session::resend_asked(const Reply& reply, Instant now) {
  recovery_.resend_heard(rules().numbered, now);
  if (!rules().numbered || !reply.number || *reply.number < 0 ||
      *reply.number > kResyncLineNumber || !can_go_back_to(window_.sequence_of(*reply.number))) {
    resend_doubted(reply);
    return;
  }
  const std::int64_t sequence = window_.sequence_of(*reply.number);
  recovery_.account_told(sequence == window_.sent_end());
  const bool repeats = sequence < window_.next_to_send() && !recovery_.waits_for_quiet();
  if (repeats && !repeat_from(sequence)) return;
  window_.restart(sequence);
  position_.repeated_from(sequence);
  // After a silence, the `ok`s of accepted lines are not late but lost. Where a garbled number had
  // sent us back, and this one sends us on again, they have come long ago.
  if (recovery_.asked() || window_.lines_in_flight() > kWindowLinesMax) {
    const std::int64_t before = window_.acknowledged();
    window_.acknowledge_before(sequence);
    note_accepted(before, now);
    if (ended()) return;
  }
  if (recovery_.asked()) {
    recovery_.answered();
    if (state_ == SessionState::kStopping && !stop_.has_start()) {
      window_.drop_unsent();
      recovery_.confirm();
      stop_.starts_at(sequence);
    }
  }
  recovery_.wait_for_quiet();
}

// A line was asked for that cannot be the next.
void Session::resend_doubted(const Reply& reply) {
  ++statistics_.resends_ignored;
  switch (recovery_.doubt(rules().numbered ? reply.number : std::nullopt)) {
    case Recovery::Doubt::kIgnore:
      return;
    case Recovery::Doubt::kAskAgain:
      put_forced_mismatch();
      return;
    case Recovery::Doubt::kCounterJumped:
      fault(FaultKind::kRefusals,
            "the controller says that it has had " + std::to_string(*reply.number - 1) +
                " lines of " + std::to_string(window_.number_of(window_.next_to_send()) - 1) +
                ": it was reset, or counts wrong",
            true);
      return;
  }
}

bool Session::can_go_back_to(std::int64_t sequence) const {
  return window_.can_restart(sequence) && window_.acknowledged() - sequence <= kFalseAnswersMax;
}

// A line was refused and will be repeated; false when that has happened too often.
bool Session::repeat_from(std::int64_t sequence) {
  ++statistics_.resends;
  if (!recovery_.repeats(sequence, options_.repeats_of_a_line_max)) {
    fault(FaultKind::kRefusals,
          "the controller refused line " + std::to_string(window_.number_of(sequence)) + " " +
              std::to_string(recovery_.repeats_of_a_line()) +
              " times: " + in_quotes(complaints_.last_refusal()),
          true);
    return false;
  }
  // A line that was cut may have run in part.
  if (rules().tells_position && phase_ == Phase::kOpen) requests_.ask_position();
  if (recovery_.tells_frequent(statistics_.lines_sent, statistics_.resend_ratio())) {
    events_.push(SessionEvent::Kind::kResendsFrequent,
                 std::to_string(statistics_.resends) + " of " +
                     std::to_string(statistics_.lines_sent) +
                     " lines were asked for again: look at the cable, its length, the baud");
  }
  return true;
}

}  // namespace firmware_link
