// The half of the session that listens.
#include <algorithm>
#include <string>

#include "firmware_link/dialects/dialects.h"  // is_known_firmware
#include "firmware_link/session/session.h"
#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

// One line in flight after a Resend, until this many have gone well: twice as many each time that
// it comes again soon, because a receive ring may be smaller than was thought (64 bytes are found).
constexpr std::int64_t kCalmLinesMin = 8;
constexpr std::int64_t kCalmLinesMax = 4096;

// So many of the lines asked for again are worth a warning, once so many were sent.
constexpr double kResendRatioMax = 0.1;
constexpr std::int64_t kResendLinesMin = 100;

// An `ok` too many uncovers itself by a request for a line that was acknowledged; so many of them
// in a row are another thing.
constexpr std::int64_t kFalseAnswersMax = 8;

// So many `start`s while connecting are no boot loader's any more.
constexpr int kStartsMax = 10;

std::string quoted(std::string_view words) { return "\"" + std::string(words) + "\""; }

}  // namespace

void Session::input(std::span<const std::byte> bytes, Instant now) {
  bridge_gap(now);
  if (!bytes.empty()) last_heard_ = now;
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
  const Meaning meaning = dialect_->meaning_of(reply);
  if (meaning != Meaning::kNoise) last_life_ = now;
  if (reply.kind != Reply::Kind::kTemperatures) last_said_ = now;
  if (meaning == Meaning::kWorking || meaning == Meaning::kAcknowledge) {
    last_progress_ = now;
    if (meaning == Meaning::kWorking) silence_.worked();
    if (meaning == Meaning::kAcknowledge) silence_.answered();
  }
  if (reply.text.substr(0, kMeatPackAnswer.size()) == kMeatPackAnswer) packing_.heard(reply.text);
  note_temperatures(reply, now);
  if (ended()) return;
  note_names(reply);
  if (reply.kind == Reply::Kind::kAction) note_action(reply.text);
  if (reply.kind == Reply::Kind::kBusy &&
      reply.text.find("paused for user") != std::string_view::npos && !waits_for_user_) {
    waits_for_user_ = true;
    events_.push(SessionEvent::Kind::kWaitsForUser, std::string(reply.text));
  }
  if (reply.kind == Reply::Kind::kPosition && question_) {
    question_->told = reply.position;
    // What was asked is answered in its turn, so all before it has been.
    if (!rules_.numbered && question_->sequence > window_.acknowledged() &&
        question_->sequence < window_.next_to_send()) {
      const std::int64_t before = window_.acknowledged();
      acknowledge_through(question_->sequence - 1);
      note_accepted(before, now);
      if (ended()) return;
    }
  }

  if (shut_down_since_) {
    reply_while_shut_down(reply);
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
  if (meaning == Meaning::kAlarm && dialect_->lost_its_place(reply.text)) {
    place_lost(reply.text, now);
    return;
  }
  if (place_lost_since_ && meaning != Meaning::kReset) return;
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
  if (meaning != Meaning::kAcknowledge && meaning != Meaning::kResend) skip_next_ok_ = false;
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
      skip_next_ok_ = true;
      quiet_since_ = now;
      accounts_.refused(reply.text);
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
      if (phase_ == Phase::kAsking) named_ = true;
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
      resyncs_in_a_row_ = resync_pending_ ? 1 : 0;
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
    if (++starts_seen_ > kStartsMax) {
      fault(FaultKind::kNoAnswer,
            "the controller resets itself again and again: is its power supply right?", false);
      return;
    }
    // It may come late, behind a greeting that the boot loader ate.
    start_seen_ = true;
    found_line_.reset();  // it told that before, and knows it no longer
    phase_ = Phase::kBanner;
    phase_began_ = now;
    window_.restart(window_.oldest());
    window_.drop_unsent();
    recovering_ = resync_pending_ = skip_next_ok_ = named_ = false;
    return;
  }
  fault(FaultKind::kReset, "the controller was reset in mid-print, and has forgotten its position",
        false);
}

void Session::note_names(const Reply& reply) {
  // Klipper says its name in the `ok` itself. Nobody else does, so a damaged one is Klipper's, too.
  constexpr std::string_view kName = "FIRMWARE_NAME:";
  if (reply.kind == Reply::Kind::kFirmwareName) named(reply.text);
  if (reply.kind == Reply::Kind::kOk && reply.text.substr(0, kName.size()) == kName) {
    const std::string_view name = reply.text.substr(kName.size());
    named(is_known_firmware(firmware_name_in(name)) ? name : "Klipper");
  }
  if (reply.kind == Reply::Kind::kCapability) note_capability(reply.text, capabilities_);
  if (reply.kind == Reply::Kind::kEcho || reply.kind == Reply::Kind::kUnknown) {
    note_travel(reply.text, capabilities_);
  }
  if (reply.kind == Reply::Kind::kOk && reply.planner_free) {
    capabilities_.advanced_ok = true;
    capabilities_.planner_blocks = std::max(capabilities_.planner_blocks, *reply.planner_free);
  }
}

void Session::acknowledged(const Reply& reply, Instant now) {
  waits_for_user_ = false;
  if (recovering_) quiet_since_ = now;
  if (skip_next_ok_) {
    skip_next_ok_ = false;
    return;
  }
  // An `ok` before the answer to M115 is to a line of a host before us.
  if (phase_ == Phase::kAsking && !named_) {
    ++statistics_.stray_acknowledgements;
    return;
  }
  resyncs_in_a_row_ = resync_pending_ ? 1 : 0;
  if (calm_lines_missing_ > 0) --calm_lines_missing_;
  bool ours = false;
  const std::int64_t before = window_.acknowledged();
  if (reply.number && rules_.numbered) {
    // Bounded before the sum, because any number may come.
    const std::int64_t number = std::clamp<std::int64_t>(*reply.number, 0, kResyncLineNumber);
    const std::int64_t sequence = window_.sequence_of(number);
    ours = sequence >= window_.acknowledged() && sequence < window_.next_to_send();
    if (ours) window_.acknowledge_before(sequence + 1);
  } else if (names_a_line(reply)) {
    const std::optional<std::int64_t> through = named_by(reply);
    ours = through.has_value();
    if (ours) {
      acknowledge_through(*through);
      if (ended()) return;
    }
  } else {
    ours = window_.acknowledge_one();
    late_answers_ = 0;
  }
  if (!ours) {
    ++statistics_.stray_acknowledgements;
    return;
  }
  accounts_.possible();
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
  skip_next_ok_ = rules_.numbered;
  quiet_since_ = now;
  if (!rules_.numbered || !reply.number || *reply.number < 0 || *reply.number > kResyncLineNumber ||
      !can_go_back_to(window_.sequence_of(*reply.number))) {
    ++statistics_.resends_ignored;
    if (rules_.numbered && reply.number && accounts_.impossible(*reply.number)) {
      fault(FaultKind::kRefusals,
            "the controller says that it has had " + std::to_string(*reply.number - 1) +
                " lines of " + std::to_string(window_.number_of(window_.next_to_send()) - 1) +
                ": it was reset, or counts wrong",
            true);
    } else if (accounts_.ask_again() && !recovering_) {
      put_forced_mismatch();
    }
    return;
  }
  accounts_.possible();
  const std::int64_t sequence = window_.sequence_of(*reply.number);
  confirmed_ = sequence == window_.sent_end();
  mismatches_ = 0;
  if (confirmed_) resyncs_in_a_row_ = 0;
  if (sequence < window_.next_to_send() && !recovering_ && !repeat_from(sequence)) return;
  window_.restart(sequence);
  if (question_ && sequence <= question_->sequence) question_->told.reset();
  // After a silence, the `ok`s of accepted lines are not late but lost. Where a garbled number had
  // sent us back, and this one sends us on again, they have come long ago.
  if (resync_pending_ || window_.lines_in_flight() > kWindowLinesMax) {
    const std::int64_t before = window_.acknowledged();
    window_.acknowledge_before(sequence);
    note_accepted(before, now);
    if (ended()) return;
  }
  if (resync_pending_) {
    resync_pending_ = false;
    if (state_ == SessionState::kStopping && !end_of_commands_) {
      window_.drop_unsent();
      confirmed_ = true;
      end_of_commands_ = sequence;
    }
  }
  recovering_ = true;
}

bool Session::can_go_back_to(std::int64_t sequence) const {
  return window_.can_restart(sequence) && window_.acknowledged() - sequence <= kFalseAnswersMax;
}

// A line was refused and will be repeated; false when that has happened too often.
bool Session::repeat_from(std::int64_t sequence) {
  ++statistics_.resends;
  if (sequence > repeated_line_) {
    repeated_line_ = sequence;
    repeats_of_a_line_ = 0;
  }
  if (++repeats_of_a_line_ > options_.repeats_of_a_line_max) {
    fault(FaultKind::kRefusals,
          "the controller refused line " + std::to_string(window_.number_of(sequence)) + " " +
              std::to_string(repeats_of_a_line_) + " times: " + quoted(last_refusal_),
          true);
    return false;
  }
  const bool soon = sequence - refused_last_ < 4 * calm_lines_;
  calm_lines_ = soon ? std::min(2 * calm_lines_, kCalmLinesMax) : kCalmLinesMin;
  calm_lines_missing_ = calm_lines_;
  refused_last_ = sequence;
  // A line that was cut may have run in part.
  if (rules_.tells_position && phase_ == Phase::kOpen) own_requests_.ask_position = true;
  if (!warned_of_resends_ && statistics_.lines_sent >= kResendLinesMin &&
      statistics_.resend_ratio() >= kResendRatioMax) {
    warned_of_resends_ = true;
    events_.push(SessionEvent::Kind::kResendsFrequent,
                 std::to_string(statistics_.resends) + " of " +
                     std::to_string(statistics_.lines_sent) +
                     " lines were asked for again: look at the cable, its length, the baud");
  }
  return true;
}

}  // namespace firmware_link
