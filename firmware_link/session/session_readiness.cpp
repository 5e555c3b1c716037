// Whether a controller that answers is also ready to print, where it is, and why it has shut down:
// for those that are a program on a computer (Klipper).
//
//     asking, settling ──> state? ──ready──────────────────────────> streaming
//                           ▲  │ └──ready, to resume──> where? knows? homed? ──┘
//                           └──┘ not ready yet: each second, up to ready_wait
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include "firmware_link/session/session.h"

namespace firmware_link {
namespace {

std::string quoted(std::string_view words) { return "\"" + std::string(words) + "\""; }

std::string with_remedy(std::string text, std::string_view remedy) {
  return remedy.empty() ? text : text + "; " + std::string(remedy);
}

}  // namespace

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

void Session::reply_while_readying(const Reply& reply, Meaning meaning, Instant now) {
  readiness_.heard(reply, dialect(), identity_.capabilities());
  if (meaning != Meaning::kAcknowledge) return;
  if (names_a_line(reply)) {
    // What it said before may have been lost with its `ok`: the same is asked again.
    const auto through = questions_.answered(window_);
    if (through && OrderedQuestions::acknowledge_through(window_, *through)) {
      ask_whether_ready(now);
    }
  } else if (window_.acknowledge_one()) {
    go_on_readying(readiness_.answered(dialect(), options_.ask_found_line, now), now);
  }
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

void Session::tick_shut_down(Instant now) {
  if (!shutdown_.over(window_.lines_in_flight() > 0, now)) return;
  if (shutdown_.is_shut_down()) {
    end_shut_down(shutdown_.words());
  } else {
    fault(FaultKind::kAlarm, "the controller refused a command: " + quoted(shutdown_.words()),
          true);
  }
}

void Session::end_shut_down(std::string_view reason) {
  halted("the controller has shut down: " + quoted(reason));
}

void Session::halted(const std::string& why) {
  fault(FaultKind::kHalted, with_remedy(why, dialect().remedy()), false);
}

}  // namespace firmware_link
