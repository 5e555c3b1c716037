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
      if (!last_refusal_.empty()) why += " It said \"" + last_refusal_ + "\"";
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

void Session::reply_while_greeting(const Reply& reply, Meaning meaning, Instant now) {
  if (phase_ == Phase::kReadying) {
    reply_while_readying(reply, meaning, now);
    return;
  }
  if (phase_ != Phase::kGreeting) return;
  if (meaning == Meaning::kResend || meaning == Meaning::kRefused) {
    last_refusal_ = std::string(reply.text);
  }
  if (greeting_.accepted_by(reply, meaning)) greeted(now);
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

// Its name may have been damaged beyond recognition, and by now something else is answered.
void Session::tick_asking(Instant now) {
  if (phase_ != Phase::kAsking || silence_.works() || !greeting_.name_overdue(now)) return;
  window_.restart(window_.oldest());
  window_.drop_unsent();
  recovery_.restart();
  identity_.ask_again();
  if (greeting_.may_greet_again(options_)) {
    greet(now);
  } else {
    fault(FaultKind::kNoAnswer, "the controller answers, but does not say what it is", true);
  }
}

bool Session::asks_name_again(Instant now) {
  if (!identity_.doubts_name()) return false;
  push_own("M115");
  pump(now);
  return true;
}

// What asks for names has been answered, to its `ok`. True when late answers must come first.
bool Session::adopt_dialect() {
  const bool settles = identity_.adopt_dialect();
  events_.push(SessionEvent::Kind::kDialect, std::string(dialect().name()));
  recovery_.dialect_found();
  return settles;
}

void Session::open(Instant now) {
  phase_ = Phase::kOpen;
  state_ = SessionState::kStreaming;
  signs_.expect_answer(now);
  last_polled_ = now;
  own_requests_.report_temperatures =
      options_.temperature_interval.count() > 0 && identity_.capabilities().autoreport_temperatures;
}

}  // namespace firmware_link
