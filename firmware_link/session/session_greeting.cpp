// How a conversation begins: numbers from 0, a name, the dialect that goes with it.
#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "firmware_link/dialects/dialects.h"  // dialect_for
#include "firmware_link/session/session.h"
#include "firmware_link/wire/check.h"
#include "firmware_link/wire/line_codec.h"  // number_line

namespace firmware_link {
namespace {

// A greeting begins only when the controller has said all that it says by itself.
constexpr Duration kQuiet = std::chrono::milliseconds(200);

// One that never stops talking is greeted all the same.
constexpr Duration kTalkMax = std::chrono::seconds(3);

// How long it may work at what the host before us told it.
constexpr Duration kBusyMax = std::chrono::minutes(15);

constexpr int kAsksMax = 2;

// How long a name is waited for before all begins anew, and how often it is asked for.
constexpr Duration kNameWait = std::chrono::seconds(15);
constexpr int kNamesMax = 3;

}  // namespace

void Session::tick_greeting(Instant now) {
  const bool quiet = now - last_said_ >= kQuiet;
  const Duration waited = now - phase_began_;
  if (phase_ == Phase::kSettling) {
    if ((quiet && waited >= kQuiet) || waited >= kTalkMax) begin_readying(now);
    return;
  }
  if (phase_ == Phase::kBanner) {
    const Duration first = start_seen_ ? Duration(0) : options_.banner_wait;
    if (waited >= first && (quiet || waited >= first + kTalkMax)) greet(now);
    return;
  }
  const bool late =
      now - std::max(phase_began_, last_progress_) >= options_.greeting_wait || waited >= kBusyMax;
  if (!late && !(greeting_refused_ && quiet)) return;
  if (greetings_ == 1 && late)
    events_.push(SessionEvent::Kind::kWaits, "an answer to the greeting");
  if (greetings_ < options_.greetings_max) {
    greet(now);
    return;
  }
  std::string why =
      start_seen_ ? "the controller started but does not answer; is the baud right?"
                  : "no answer from the controller: is it the right port, and the right baud?";
  if (!last_refusal_.empty()) why += " It said \"" + last_refusal_ + "\"";
  fault(FaultKind::kNoAnswer, why, true);
}

void Session::greet(Instant now) {
  const bool unanswered = phase_ == Phase::kGreeting && !greeting_refused_;
  const bool ask_line = options_.ask_found_line && !start_seen_ && lines_asked_ < kAsksMax &&
                        (phase_ == Phase::kBanner || (unanswered && asking_line_));
  // The host before us may have left it with packed lines. Not each time: Klipper drops all that
  // comes along with such bytes.
  const bool maybe_packed = unanswered && (ask_line || greetings_ % 2 == 1);
  phase_ = Phase::kGreeting;
  phase_began_ = now;
  greeting_refused_ = false;
  greeting_skips_ok_ = false;
  recovery_.greeting_sent();
  asking_line_ = ask_line;
  lines_asked_ += ask_line ? 1 : 0;
  if (!ask_line) ++greetings_;
  if (!output_.has_room_for(2 * kLineBytesMax)) return;
  LineBuffer buffer;
  // The end of line first finishes whatever half line the controller may hold. The number is that
  // of the line itself, which Marlin sets as it reads it; "M110 N0" would set it again when its
  // turn in the queue comes, behind lines that an `ok` too many has let in, which were then run
  // twice. It is numbered for all dialects: those that number nothing read over it.
  if (maybe_packed && options_.pack) output_.put(kMeatPackReset);
  output_.put("\n");
  output_.put(ask_line ? number_line(kResyncLineNumber, "M105", buffer)
                       : number_line(0, "M110", buffer));
  output_.put("\n");
}

void Session::reply_while_greeting(const Reply& reply, Meaning meaning, Instant now) {
  if (phase_ == Phase::kReadying) {
    reply_while_readying(reply, meaning, now);
    return;
  }
  if (phase_ != Phase::kGreeting) return;
  if (meaning == Meaning::kResend || meaning == Meaning::kRefused) {
    if (asking_line_ && meaning == Meaning::kResend && reply.number && *reply.number >= 1 &&
        *reply.number <= kLineNumberMax) {
      found_line_ = static_cast<std::int32_t>(*reply.number - 1);
    }
    greeting_refused_ = true;
    greeting_skips_ok_ = true;
    last_refusal_ = std::string(reply.text);
  } else if (meaning == Meaning::kWarning) {
    // "Unknown command" to what is left of a damaged greeting.
    greeting_refused_ = true;
    greeting_skips_ok_ = true;
  } else if (meaning == Meaning::kAcknowledge) {
    if (greeting_skips_ok_) {
      greeting_skips_ok_ = false;
    } else if (asking_line_) {
      greeting_refused_ = true;  // it numbers nothing, so there is no last line
    } else if (!greeting_refused_) {
      greeted(now);
    }
  }
}

// Line numbers have begun anew; what is sent next is N1.
void Session::greeted(Instant now) {
  window_.forget_acknowledged();
  window_.restart_numbers();
  recovery_.numbers_restarted();
  last_life_ = last_progress_ = now;
  if (state_ == SessionState::kConnecting) {
    phase_ = Phase::kAsking;
    phase_began_ = now;
    push_own("M115");
  } else {
    phase_ = Phase::kOpen;
  }
}

// Its name may have been damaged beyond recognition, and by now something else is answered.
void Session::tick_asking(Instant now) {
  if (phase_ != Phase::kAsking || silence_.works() || now - phase_began_ < kNameWait) return;
  window_.restart(window_.oldest());
  window_.drop_unsent();
  recovery_.restart();
  named_ = false;
  if (greetings_ < options_.greetings_max) {
    greet(now);
  } else {
    fault(FaultKind::kNoAnswer, "the controller answers, but does not say what it is", true);
  }
}

// A name that is not known may be a damaged one: it is believed when it comes twice. By another
// dialect nothing would work.
bool Session::asks_name_again(Instant now) {
  if (is_known_firmware(firmware_name_) || firmware_name_ == name_before_ ||
      ++names_asked_ >= kNamesMax) {
    return false;
  }
  name_before_ = firmware_name_;
  named_ = false;
  push_own("M115");
  pump(now);
  return true;
}

void Session::named(std::string_view name) {
  firmware_name_ = firmware_name_in(name);
  named_ = true;
}

// What asks for names has been answered, to its `ok`.
void Session::speak_its_dialect() {
  std::unique_ptr<Dialect> found = dialect_for(firmware_name_);
  found->amend(capabilities_);
  events_.push(SessionEvent::Kind::kDialect, std::string(found->name()));
  const bool numbered = rules_.numbered;
  dialect_ = std::move(found);
  rules_ = dialect_->rules();
  LINK_CHECK(rules_.window_lines >= 1 && rules_.window_lines <= kWindowLinesMax);
  LINK_CHECK(rules_.window_bytes > kLineBytesMax && rules_.window_bytes <= kWindowBytesMax);
  LINK_CHECK(!rules_.numbered || !rules_.checksummed);
  recovery_.dialect_found();
  // Where nothing is numbered, an `ok` to a question that was asked twice can't be told from one
  // to a command: all must have come.
  settling_needed_ = numbered && !rules_.numbered;
}

void Session::open(Instant now) {
  phase_ = Phase::kOpen;
  state_ = SessionState::kStreaming;
  last_life_ = last_progress_ = last_polled_ = now;
  own_requests_.report_temperatures =
      options_.temperature_interval.count() > 0 && capabilities_.autoreport_temperatures;
}

}  // namespace firmware_link
