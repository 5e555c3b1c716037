#include "firmware_link/session/readiness.h"

#include <chrono>
#include <cmath>
#include <cstdio>

#include "firmware_link/wire/quotes.h"  // in_quotes

namespace firmware_link {
namespace {

constexpr Duration kAskAgain = std::chrono::seconds(1);

// A height that is no printer's would not be written in full.
constexpr double kHeightMaxMm = 1e5;

}  // namespace

void Readiness::start(Instant now) {
  since_ = now;
  query_ = Query::kState;
}

void Readiness::asks() {
  alarm_.clear();
  ask_due_.reset();
}

std::string Readiness::question(const Dialect& dialect) const {
  switch (query_) {
    case Query::kState:
      return std::string(dialect.state_question());
    case Query::kPosition:
      return "M114";
    case Query::kCommands:
      return std::string(dialect.commands_question());
    case Query::kAbsolute:
      return "G90";
    case Query::kHomed: {
      // A thousandth of a millimetre up, which no stepper does: a controller that does not know
      // where it is refuses it.
      char text[32];
      std::snprintf(text, sizeof text, "G1 Z%.3f F60", *found_position_->z_mm + 0.001);
      return text;
    }
  }
  return {};
}

void Readiness::heard(const Reply& reply, const Dialect& dialect, Capabilities& capabilities) {
  if (reply.kind == Reply::Kind::kAlarm) {
    alarm_ = std::string(reply.text);
  } else if (reply.kind == Reply::Kind::kPosition && query_ == Query::kPosition) {
    found_position_ = reply.position;
  } else if (reply.kind == Reply::Kind::kNote && query_ == Query::kCommands) {
    dialect.note_command(reply.text, capabilities);
  }
}

Readiness::Step Readiness::ask(Query query) {
  query_ = query;
  return Step::kAsk;
}

Readiness::Step Readiness::answered(const Dialect& dialect, bool to_resume, Instant now) {
  switch (query_) {
    case Query::kState:
      return state_told(dialect, to_resume, now);
    case Query::kPosition:
      return ask(Query::kCommands);
    case Query::kCommands: {
      const bool known = found_position_ && found_position_->z_mm &&
                         std::abs(*found_position_->z_mm) < kHeightMaxMm;
      return known ? ask(Query::kAbsolute) : Step::kReady;
    }
    case Query::kAbsolute:
      return ask(Query::kHomed);
    case Query::kHomed:
      found_homed_ = !dialect.lost_its_position(alarm_);
      return Step::kReady;
  }
  return Step::kWait;
}

Readiness::Step Readiness::state_told(const Dialect& dialect, bool to_resume, Instant now) {
  if (alarm_.empty()) {
    if (!to_resume || dialect.commands_question().empty()) return Step::kReady;
    return ask(Query::kPosition);
  }
  if (!dialect.becomes_ready(alarm_)) {
    reason_ = "the controller is not ready: " + in_quotes(alarm_);
    return Step::kFault;
  }
  const bool news = words_ != alarm_;
  words_ = alarm_;
  ask_due_ = now + kAskAgain;
  return news ? Step::kNotReady : Step::kWait;
}

Readiness::Step Readiness::tick(Duration ready_wait, Instant now) {
  if (now - since_ > ready_wait) {
    reason_ = words_.empty() ? "the controller did not answer whether it is ready"
                             : "the controller did not become ready: " + in_quotes(words_);
    return Step::kFault;
  }
  return ask_due_ && now >= *ask_due_ ? ask(Query::kState) : Step::kWait;
}

}  // namespace firmware_link
