// The half of the session that listens.
#include <algorithm>
#include <string>

#include "firmware_link/check.h"
#include "firmware_link/session.h"

namespace firmware_link {
namespace {

// One line in flight after a Resend, until this many have gone well.
constexpr int kCalmLines = 8;

// "FIRMWARE_NAME:Marlin 2.1 (date) SOURCE_CODE_URL:…": values hold blanks, so the name ends where
// the next KEY: begins.
std::string name_in(std::string_view text) {
  for (std::size_t blank = text.find(' '); blank != std::string_view::npos;
       blank = text.find(' ', blank + 1)) {
    std::size_t end = blank + 1;
    while (end < text.size() && ((text[end] >= 'A' && text[end] <= 'Z') || text[end] == '_')) ++end;
    if (end > blank + 1 && end < text.size() && text[end] == ':')
      return std::string(text.substr(0, blank));
  }
  return std::string(text);
}

std::string quoted(std::string_view words) { return "\"" + std::string(words) + "\""; }

void update(std::optional<double>& known, const std::optional<double>& heard) {
  if (heard) known = heard;
}

}  // namespace

void Session::input(std::span<const std::byte> bytes, Instant now) {
  if (!bytes.empty()) last_heard_ = now;
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
  if (meaning == Meaning::kWorking || meaning == Meaning::kAcknowledge) last_progress_ = now;
  Temperatures& known = statistics_.temperatures;
  update(known.nozzle_celsius, reply.temperatures.nozzle_celsius);
  update(known.nozzle_target_celsius, reply.temperatures.nozzle_target_celsius);
  update(known.bed_celsius, reply.temperatures.bed_celsius);
  update(known.bed_target_celsius, reply.temperatures.bed_target_celsius);
  if (reply.kind == Reply::Kind::kFirmwareName) {
    firmware_name_ = name_in(reply.text);
    named_ = true;
  }

  if (meaning == Meaning::kFatal) {
    fault("the controller stopped: " + quoted(reply.text), false);
    return;
  }
  if (meaning == Meaning::kReset) {
    reset_seen(now);
    return;
  }
  if (phase_ == Phase::kBanner || phase_ == Phase::kGreeting) {
    reply_while_greeting(reply, meaning, now);
    return;
  }
  // Nothing comes between a refusal and its `ok`; a line that does means that the `ok` got lost.
  if (meaning != Meaning::kAcknowledge && meaning != Meaning::kResend) skip_next_ok_ = false;
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
      last_refusal_ = std::string(reply.text);
      break;
    case Meaning::kWarning:
      ++statistics_.warnings;
      last_warning_ = std::string(reply.text);
      if (phase_ == Phase::kAsking) named_ = true;
      break;
    case Meaning::kNoise:
    case Meaning::kAlive:
    case Meaning::kWorking:
      if (meaning == Meaning::kWorking) resyncs_in_a_row_ = resync_pending_ ? 1 : 0;
      break;
    case Meaning::kReset:
    case Meaning::kFatal:
      LINK_CHECK(false);
  }
}

void Session::reset_seen(Instant now) {
  if (state_ == SessionState::kConnecting) {
    // It may come late, behind a greeting that the boot loader ate.
    start_seen_ = true;
    phase_ = Phase::kBanner;
    phase_began_ = now;
    window_.restart(window_.oldest());
    window_.drop_unsent();
    recovering_ = resync_pending_ = skip_next_ok_ = named_ = false;
    return;
  }
  fault("the controller was reset in mid-print: it said \"start\", and has forgotten its position",
        false);
}

void Session::reply_while_greeting(const Reply& reply, Meaning meaning, Instant now) {
  if (phase_ != Phase::kGreeting) return;
  if (meaning == Meaning::kResend || meaning == Meaning::kRefused) {
    greeting_refused_ = true;
    skip_next_ok_ = true;
    last_refusal_ = std::string(reply.text);
  } else if (meaning == Meaning::kWarning) {
    // "Unknown command" to what is left of a damaged greeting; some firmware knows no M110 at all,
    // but then it numbers nothing either.
    greeting_refused_ = rules_.numbered;
    skip_next_ok_ = rules_.numbered;
  } else if (meaning == Meaning::kAcknowledge) {
    if (skip_next_ok_) {
      skip_next_ok_ = false;
    } else if (!greeting_refused_) {
      greeted(now);
    }
  }
}

// Line numbers have begun anew; what is sent next is N1.
void Session::greeted(Instant now) {
  window_.forget_acknowledged();
  numbering_base_ = window_.next_to_send() - 1;
  repeated_line_ = -1;
  last_life_ = last_progress_ = now;
  if (state_ == SessionState::kConnecting) {
    phase_ = Phase::kAsking;
    window_.push("M115");
  } else {
    phase_ = Phase::kOpen;
  }
}

void Session::acknowledged(const Reply& reply, Instant now) {
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
  if (reply.number && rules_.numbered) {
    // Bounded before the sum, because any number may come.
    const std::int64_t number = std::clamp<std::int64_t>(*reply.number, 0, kResyncLineNumber);
    const std::int64_t sequence = number + numbering_base_;
    ours = sequence >= window_.acknowledged() && sequence < window_.next_to_send();
    if (ours) window_.acknowledge_before(sequence + 1);
  } else {
    ours = window_.acknowledge_one();
  }
  if (!ours) {
    ++statistics_.stray_acknowledgements;
    return;
  }
  if (state_ == SessionState::kStreaming && phase_ == Phase::kOpen && window_.all_sent() &&
      window_.lines_in_flight() == 0) {
    ++statistics_.stalls;
  }
}

void Session::resend_asked(const Reply& reply, Instant now) {
  skip_next_ok_ = rules_.numbered;
  quiet_since_ = now;
  if (!rules_.numbered || !reply.number || *reply.number < 0 || *reply.number > kResyncLineNumber ||
      !window_.can_restart(*reply.number + numbering_base_)) {
    ++statistics_.resends_ignored;
    return;
  }
  const std::int64_t sequence = *reply.number + numbering_base_;
  confirmed_ = sequence == window_.sent_end();
  if (confirmed_) resyncs_in_a_row_ = 0;
  const bool repeats = sequence < window_.next_to_send() && !recovering_;
  if (repeats) {
    ++statistics_.resends;
    if (sequence > repeated_line_) {
      repeated_line_ = sequence;
      repeats_of_a_line_ = 0;
    }
    if (++repeats_of_a_line_ > options_.repeats_of_a_line_max) {
      fault("the controller refused line " + std::to_string(*reply.number) + " " +
                std::to_string(repeats_of_a_line_) + " times: " + quoted(last_refusal_),
            true);
      return;
    }
    calm_lines_missing_ = kCalmLines;
  }
  window_.restart(sequence);
  if (resync_pending_) {
    // After a silence, the `ok`s of accepted lines are not late but lost.
    window_.acknowledge_before(sequence);
    resync_pending_ = false;
    if (state_ == SessionState::kStopping && !end_of_commands_) {
      window_.drop_unsent();
      confirmed_ = true;
      end_of_commands_ = sequence;
    }
  }
  recovering_ = true;
}

}  // namespace firmware_link
