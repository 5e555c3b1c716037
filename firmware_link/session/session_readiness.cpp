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

constexpr Duration kAskAgain = std::chrono::seconds(1);

// A shutdown's reason comes within milliseconds, as the answer to our question; where something was
// in flight, that ends first (a homing took more than a second).
constexpr Duration kReasonWait = std::chrono::seconds(1);
constexpr Duration kReasonWaitBehind = std::chrono::seconds(3);

std::string quoted(std::string_view words) { return "\"" + std::string(words) + "\""; }

std::string with_remedy(std::string text, std::string_view remedy) {
  return remedy.empty() ? text : text + "; " + std::string(remedy);
}

}  // namespace

void Session::begin_readying(Instant now) {
  if (dialect_->state_question().empty()) {
    open(now);
    return;
  }
  phase_ = Phase::kReadying;
  phase_began_ = now;
  ask_when_readying(Query::kState, now);
}

void Session::ask_when_readying(Query query, Instant now) {
  query_ = query;
  query_alarm_.clear();
  query_due_.reset();
  last_progress_ = now;
  switch (query) {
    case Query::kState:
      push_own(dialect_->state_question());
      return;
    case Query::kPlace:
      push_own("M114");
      return;
    case Query::kCommands:
      push_own(dialect_->commands_question());
      return;
    case Query::kModes:
      push_own("G90");
      return;
    case Query::kHomed: {
      // A thousandth of a millimetre up, which no stepper does: one that does not know where it is
      // refuses it.
      char text[32];
      std::snprintf(text, sizeof text, "G1 Z%.3f F60", *found_place_->z_mm + 0.001);
      push_own(text);
      return;
    }
  }
}

void Session::tick_readying(Instant now) {
  if (now - phase_began_ > options_.ready_wait) {
    const std::string why = query_words_.empty()
                                ? "the controller did not answer whether it is ready"
                                : "the controller did not become ready: " + quoted(query_words_);
    fault(FaultKind::kHalted, with_remedy(why, dialect_->remedy()), false);
    return;
  }
  if (window_.lines_in_flight() > 0 && now - last_progress_ > rules_.ask_after) ask_for_answer(now);
  if (query_due_ && now >= *query_due_) ask_when_readying(Query::kState, now);
}

void Session::reply_while_readying(const Reply& reply, Meaning meaning, Instant now) {
  if (reply.kind == Reply::Kind::kAlarm) {
    query_alarm_ = std::string(reply.text);
  } else if (reply.kind == Reply::Kind::kPosition && query_ == Query::kPlace) {
    found_place_ = reply.position;
  } else if (reply.kind == Reply::Kind::kNote && query_ == Query::kCommands) {
    dialect_->note_command(reply.text, capabilities_);
  } else if (meaning == Meaning::kAcknowledge && names_a_line(reply)) {
    // What it said before may have been lost with its `ok`: the same is asked again.
    const auto through = questions_.answered(window_);
    if (through && OrderedQuestions::acknowledge_through(window_, *through)) {
      ask_when_readying(query_, now);
    }
  } else if (meaning == Meaning::kAcknowledge && window_.acknowledge_one()) {
    query_answered(now);
  }
}

void Session::query_answered(Instant now) {
  switch (query_) {
    case Query::kState:
      state_told(now);
      return;
    case Query::kPlace:
      ask_when_readying(Query::kCommands, now);
      return;
    case Query::kCommands:
      if (found_place_ && found_place_->z_mm && std::abs(*found_place_->z_mm) < 1e5) {
        ask_when_readying(Query::kModes, now);
      } else {
        open(now);
      }
      return;
    case Query::kModes:
      ask_when_readying(Query::kHomed, now);
      return;
    case Query::kHomed:
      found_homed_ = !dialect_->lost_its_place(query_alarm_);
      open(now);
      return;
  }
}

void Session::state_told(Instant now) {
  if (query_alarm_.empty()) {
    if (options_.ask_found_line && !dialect_->commands_question().empty()) {
      ask_when_readying(Query::kPlace, now);
    } else {
      open(now);
    }
    return;
  }
  if (!dialect_->becomes_ready(query_alarm_)) {
    fault(FaultKind::kHalted,
          with_remedy("the controller is not ready: " + quoted(query_alarm_), dialect_->remedy()),
          false);
    return;
  }
  if (query_words_ != query_alarm_) events_.push(SessionEvent::Kind::kNotReady, query_alarm_);
  query_words_ = query_alarm_;
  query_due_ = now + kAskAgain;
}

// The print is over; nothing more is sent but the question why.
void Session::shut_down_seen(std::string_view words, Instant now) {
  if (shut_down_since_) return;
  shut_down_since_ = now;
  shut_down_words_ = std::string(words);
  output_.clear();
  const std::string_view question = dialect_->state_question();
  if (question.empty()) return;
  output_.put("\n");
  output_.put(question);
  output_.put("\n");
}

void Session::reply_while_shut_down(const Reply& reply) {
  if (reply.kind == Reply::Kind::kAlarm) end_shut_down(reply.text);
}

// Klipper that is being restarted lets its motors go first, and refuses what comes then: that it is
// restarted, it says some milliseconds later.
void Session::place_lost(std::string_view words, Instant now) {
  if (is_still()) return;
  place_lost_since_ = now;
  shut_down_words_ = std::string(words);
  output_.clear();
}

void Session::tick_shut_down(Instant now) {
  if (!shut_down_since_) {
    if (now - *place_lost_since_ <= kReasonWait) return;
    fault(FaultKind::kAlarm, "the controller refused a command: " + quoted(shut_down_words_), true);
    return;
  }
  const bool behind = window_.lines_in_flight() > 0;
  if (now - *shut_down_since_ > (behind ? kReasonWaitBehind : kReasonWait)) {
    end_shut_down(shut_down_words_);
  }
}

void Session::end_shut_down(std::string_view reason) {
  halted("the controller has shut down: " + quoted(reason));
}

void Session::halted(const std::string& why) {
  fault(FaultKind::kHalted, with_remedy(why, dialect_->remedy()), false);
}

}  // namespace firmware_link
