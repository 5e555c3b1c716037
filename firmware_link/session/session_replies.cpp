// The half of the session that listens.
#include <algorithm>
#include <string>

#include "firmware_link/dialects/dialects.h"  // is_known_firmware
#include "firmware_link/session/session.h"
#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

// An `ok` too many uncovers itself by a request for a line that was acknowledged; so many of them
// in a row are another thing.
constexpr std::int64_t kFalseAnswersMax = 8;

std::string quoted(std::string_view words) { return "\"" + std::string(words) + "\""; }

}  // namespace

void Session::input(std::span<const std::byte> bytes, Instant now) {
  bridge_gap(now);
  if (!bytes.empty()) signs_.bytes_heard(now);
  if (listens_) {
    hear_safety(bytes);
    return;
  }
  while (!bytes.empty() && !ended()) {
    bytes = bytes.subspan(splitter_.take(bytes));
    if (const auto line = splitter_.line()) reply(read_reply(*line), now);
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
  note_temperatures(reply, now);
  if (ended()) return;
  identity_.heard(reply);
  if (reply.kind == Reply::Kind::kAction) note_action(reply.text);
  if (reply.kind == Reply::Kind::kBusy &&
      reply.text.find("paused for user") != std::string_view::npos && !waits_for_user_) {
    waits_for_user_ = true;
    events_.push(SessionEvent::Kind::kWaitsForUser, std::string(reply.text));
  }
  if (reply.kind == Reply::Kind::kPosition && question_) {
    question_->told = reply.position;
    // What was asked is answered in its turn, so all before it has been.
    if (!rules().numbered && question_->sequence > window_.acknowledged() &&
        question_->sequence < window_.next_to_send()) {
      const std::int64_t before = window_.acknowledged();
      acknowledge_through(question_->sequence - 1);
      note_accepted(before, now);
      if (ended()) return;
    }
  }

  if (shutdown_.is_shut_down()) {
    if (reply.kind == Reply::Kind::kAlarm) end_shut_down(reply.text);
    return;
  }
  // One that has just said its name may not be ready; one that has not may be Klipper, which
  // answers with alarms until it is.
  if (phase_ != Phase::kOpen && reply.kind == Reply::Kind::kAlarm) {
    last_refusal_ = std::string(reply.text);
    if (phase_ == Phase::kReadying) reply_while_readying(reply, meaning, now);
    return;
  }
  if (meaning == Meaning::kShutDown && phase_ == Phase::kOpen) {
    shut_down_seen(reply.text, now);
    return;
  }
  if (meaning == Meaning::kFatal) {
    halted("the controller stopped: " + quoted(reply.text));
    return;
  }
  if (meaning == Meaning::kAlarm && dialect().lost_its_position(reply.text)) {
    if (shutdown_.position_lost(reply.text, now)) output_.clear();
    return;
  }
  if (shutdown_.is_lost() && meaning != Meaning::kReset) return;
  if (meaning == Meaning::kAlarm) {
    fault(FaultKind::kAlarm, "the controller refused a command: " + quoted(reply.text), true);
    return;
  }
  if (meaning == Meaning::kReset) {
    reset_seen(now);
    return;
  }
  if (phase_ == Phase::kAsking || phase_ == Phase::kOpen) {
    reply_while_open(reply, meaning, now);
  } else {
    reply_while_greeting(reply, meaning, now);
  }
}

void Session::reply_while_open(const Reply& reply, Meaning meaning, Instant now) {
  // Nothing comes between a refusal and its `ok`; a line that does means that the `ok` got lost.
  if (meaning != Meaning::kAcknowledge && meaning != Meaning::kResend) recovery_.other_heard();
  if (meaning == Meaning::kAcknowledge) complaint_stands();
  if (meaning == Meaning::kResend || meaning == Meaning::kRefused) complaint_mended();
  switch (meaning) {
    case Meaning::kAcknowledge:
      acknowledged(reply, now);
      break;
    case Meaning::kResend:
      resend_asked(reply, now);
      break;
    case Meaning::kRefused:
      recovery_.refused(reply.text, now);
      last_refusal_ = std::string(reply.text);
      break;
    case Meaning::kWarning:
      if (damaged_by(reply)) {
        fault(FaultKind::kPosition,
              "a line was damaged on its way to the controller, which says " + quoted(reply.text),
              true);
        return;
      }
      complaint_heard(reply);
      if (phase_ == Phase::kAsking) identity_.name_refused();
      break;
    case Meaning::kFilamentHeld:
      // Its count goes on all the same: nothing else would show it. Before the count began it is
      // the user's own start that draws back cold.
      if (position_.expected().e_10nm && state_ == SessionState::kStreaming) {
        fault(FaultKind::kAlarm, "the controller refused to lay: " + quoted(reply.text), true);
      } else {
        warn(reply.text);
      }
      break;
    case Meaning::kNoise:
    case Meaning::kAlive:
    case Meaning::kWorking:
      if (meaning != Meaning::kWorking) break;
      recovery_.work_seen();
      break;
    case Meaning::kShutDown:  // while it is not open
      break;
    case Meaning::kReset:
    case Meaning::kAlarm:
    case Meaning::kFatal:
      LINK_CHECK(false);
  }
}

void Session::reset_seen(Instant now) {
  if (state_ == SessionState::kConnecting) {
    if (!greeting_.started(now)) {
      fault(FaultKind::kNoAnswer,
            "the controller resets itself again and again: is its power supply right?", false);
      return;
    }
    phase_ = Phase::kBanner;
    window_.restart(window_.oldest());
    window_.drop_unsent();
    recovery_.restart();
    identity_.ask_again();
    return;
  }
  fault(FaultKind::kReset, "the controller was reset in mid-print, and has forgotten its position",
        false);
}

void Session::acknowledged(const Reply& reply, Instant now) {
  waits_for_user_ = false;
  if (recovery_.skips_ok(now)) return;
  // An `ok` before the answer to M115 is to a line of a host before us.
  if (phase_ == Phase::kAsking && !identity_.name_told()) {
    ++statistics_.stray_acknowledgements;
    return;
  }
  recovery_.ok_heard();
  bool ours = false;
  const std::int64_t before = window_.acknowledged();
  if (reply.number && rules().numbered) {
    // Bounded before the sum, because any number may come.
    const std::int64_t number = std::clamp<std::int64_t>(*reply.number, 0, kResyncLineNumber);
    const std::int64_t sequence = window_.sequence_of(number);
    ours = sequence >= window_.acknowledged() && sequence < window_.next_to_send();
    if (ours) window_.acknowledge_before(sequence + 1);
  } else if (names_a_line(reply)) {
    const std::optional<std::int64_t> through = questions_.answered(window_);
    ours = through.has_value();
    if (ours) {
      acknowledge_through(*through);
      if (ended()) return;
    }
  } else {
    ours = window_.acknowledge_one();
    questions_.plain_ok_heard();
  }
  if (!ours) {
    ++statistics_.stray_acknowledgements;
    return;
  }
  recovery_.account_possible();
  note_accepted(before, now);
  if (reply.planner_free) planner_.told_free(*reply.planner_free, now);
  if (state_ == SessionState::kStreaming && !holding_ && phase_ == Phase::kOpen &&
      window_.all_sent() && window_.lines_in_flight() == 0) {
    ++statistics_.stalls;
  }
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
  if (question_ && sequence <= question_->sequence) question_->told.reset();
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
    if (state_ == SessionState::kStopping && !end_of_commands_) {
      window_.drop_unsent();
      recovery_.confirm();
      end_of_commands_ = sequence;
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
              std::to_string(recovery_.repeats_of_a_line()) + " times: " + quoted(last_refusal_),
          true);
    return false;
  }
  // A line that was cut may have run in part.
  if (rules().tells_position && phase_ == Phase::kOpen) own_requests_.ask_position = true;
  if (recovery_.tells_frequent(statistics_.lines_sent, statistics_.resend_ratio())) {
    events_.push(SessionEvent::Kind::kResendsFrequent,
                 std::to_string(statistics_.resends) + " of " +
                     std::to_string(statistics_.lines_sent) +
                     " lines were asked for again: look at the cable, its length, the baud");
  }
  return true;
}

}  // namespace firmware_link
