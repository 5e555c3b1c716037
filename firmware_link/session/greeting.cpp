#include "firmware_link/session/greeting.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "firmware_link/wire/line_codec.h"  // number_line
#include "firmware_link/wire/meat_pack.h"   // kMeatPackReset

namespace firmware_link {
namespace {

// A greeting is sent only when the controller has said all that it says by itself.
constexpr Duration kQuiet = std::chrono::milliseconds(200);

// One that never stops talking is greeted all the same.
constexpr Duration kTalkMax = std::chrono::seconds(3);

// How long it may work at what the host before us told it.
constexpr Duration kBusyMax = std::chrono::minutes(15);

// How often it is asked for the last line of the host before us.
constexpr int kLineAsksMax = 2;

// How long a name is waited for before the conversation starts again.
constexpr Duration kNameWait = std::chrono::seconds(15);

// So many `start`s while connecting are no boot loader's any more.
constexpr int kStartsMax = 10;

}  // namespace

Greeting::Step Greeting::look(Phase phase, const SessionOptions& options, const LifeSigns& signs,
                              Instant now) const {
  const bool quiet = now - signs.line() >= kQuiet;
  const Duration waited = now - since_;
  if (phase == Phase::kSettling) {
    const bool settled = (quiet && waited >= kQuiet) || waited >= kTalkMax;
    return settled ? Step::kSettled : Step::kWait;
  }
  if (phase == Phase::kBanner) {
    const Duration first = starts_ > 0 ? Duration(0) : options.banner_wait;
    const bool due = waited >= first && (quiet || waited >= first + kTalkMax);
    return due ? Step::kGreet : Step::kWait;
  }
  const bool late =
      now - std::max(since_, signs.progress()) >= options.greeting_wait || waited >= kBusyMax;
  if (!late && !(refused_ && quiet)) return Step::kWait;
  if (!may_greet_again(options)) return Step::kGiveUp;
  return greetings_ == 1 && late ? Step::kGreetLate : Step::kGreet;
}

void Greeting::put(Phase phase, const SessionOptions& options, Instant now, OutputBuffer& output) {
  const bool unanswered = phase == Phase::kGreeting && !refused_;
  asks_line_ = options.ask_found_line && starts_ == 0 && lines_asked_ < kLineAsksMax &&
               (phase == Phase::kBanner || (unanswered && asks_line_));
  // The host before us may have left the controller with packed lines. Its unpacker is not reset
  // each time: Klipper drops all that comes along with such bytes.
  const bool maybe_packed = unanswered && (asks_line_ || greetings_ % 2 == 1);
  since_ = now;
  refused_ = false;
  skips_ok_ = false;
  if (asks_line_) {
    ++lines_asked_;
  } else {
    ++greetings_;
  }
  if (!output.has_room_for(2 * kLineBytesMax)) return;
  LineBuffer buffer;
  if (maybe_packed && options.pack) output.put(kMeatPackReset);
  output.put("\n");
  output.put(asks_line_ ? number_line(kResyncLineNumber, "M105", buffer)
                        : number_line(0, "M110", buffer));
  output.put("\n");
}

bool Greeting::accepted_by(const Reply& reply, Meaning meaning) {
  switch (meaning) {
    case Meaning::kResend:
    case Meaning::kRefused:
      if (asks_line_ && meaning == Meaning::kResend && reply.number && *reply.number >= 1 &&
          *reply.number <= kLineNumberMax) {
        found_line_ = static_cast<std::int32_t>(*reply.number - 1);
      }
      refused_ = skips_ok_ = true;
      return false;
    case Meaning::kWarning:
      // "Unknown command" to what is left of a damaged greeting.
      refused_ = skips_ok_ = true;
      return false;
    case Meaning::kAcknowledge:
      if (std::exchange(skips_ok_, false)) return false;
      // A controller that numbers nothing has no last line.
      if (asks_line_) refused_ = true;
      return !refused_;
    default:
      return false;
  }
}

bool Greeting::started(Instant now) {
  if (++starts_ > kStartsMax) return false;
  // It may come late, behind a greeting that the boot loader ate.
  found_line_.reset();  // it told that before, and knows it no longer
  since_ = now;
  return true;
}

bool Greeting::name_overdue(Instant now) const { return now - since_ >= kNameWait; }

std::string Greeting::reason() const {
  return starts_ > 0 ? "the controller started but does not answer; is the baud right?"
                     : "no answer from the controller: is it the right port, and the right baud?";
}

}  // namespace firmware_link
