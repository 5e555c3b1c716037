// An answer is missing: what is asked, and what its answer means.
//
// Two questions. A forced mismatch runs nothing and is answered before its turn, with the last line
// that was accepted: where lines are numbered, and a command that is answered at once is in flight.
// An M105 behind all that is in flight is answered in its turn, and its answer can't be taken for
// another's: where nothing is numbered, and behind a command that takes long, which has been
// accepted long before it ends.
#include <algorithm>
#include <chrono>
#include <string>

#include "firmware_link/session/session.h"
#include "firmware_link/wire/check.h"
#include "firmware_link/wire/line_codec.h"  // number_line

namespace firmware_link {
namespace {

constexpr std::string_view kQuestion = "M105";
constexpr std::size_t kMismatchBytes = 19;

// Questions in flight, at most: behind a command that takes long they take up command slots.
constexpr int kQuestionsBehindLong = 2;
constexpr int kQuestionsMax = 4;

}  // namespace

void Session::tick_silence(Instant now) {
  if (ended() || (window_.lines_in_flight() == 0 && !recovery_.asked())) {
    silence_.over();
    return;
  }
  const SilenceWatch::Sight seen = sight(now);
  const SilenceWatch::Step step = silence_.look(rules(), seen, now);
  if (silence_.tells_wait(seen, now)) {
    events_.push(SessionEvent::Kind::kWaits, SilenceWatch::what_of(seen));
  }
  switch (step) {
    case SilenceWatch::Step::kWait:
      return;
    case SilenceWatch::Step::kAsk:
      ask(seen, now);
      return;
    case SilenceWatch::Step::kResynchronise:
      ++statistics_.resyncs;
      resynchronise(now);
      return;
    case SilenceWatch::Step::kGiveUp: {
      std::string why = silence_.reason();
      if (!last_refusal_.empty()) why += "; its last complaint was \"" + last_refusal_ + "\"";
      fault(FaultKind::kSilence, why, true);
      return;
    }
  }
}

SilenceWatch::Sight Session::sight(Instant now) const {
  SilenceWatch::Sight seen;
  if (window_.lines_in_flight() > 0) {
    seen.head = window_.acknowledged();
    seen.text = window_.text(seen.head);
  }
  // What takes longest is what is waited for.
  for (std::int64_t i = window_.acknowledged(); i < window_.next_to_send(); ++i) {
    const CommandWait wait = wait_of(window_.text(i), rules().macros);
    if (wait.limit <= seen.command.limit) continue;
    seen.command = wait;
    seen.text = window_.text(i);
  }
  // Behind it the lines of a stop wait.
  if (stop_behind_ && options_.long_stop_limit > seen.command.limit) {
    seen.command = {"a command that a stop waits for", options_.long_stop_limit, true};
    seen.text = *stop_behind_;
  }
  seen.last_life = signs_.sense();
  seen.last_progress = signs_.progress();
  seen.planner_time = std::max(Duration(0), planner_.end() - now);
  seen.questions = OrderedQuestions::in_flight(window_);
  seen.waits_for_user = waits_for_user_;
  const std::size_t bytes = kMismatchBytes * static_cast<std::size_t>(silence_.asks() + 1);
  const bool room = window_.bytes_in_flight() + bytes <= kWindowBytesMax;
  const bool in_order = !rules().numbered || seen.command.is_long();
  seen.stands = phase_ == Phase::kOpen && planner_.blocks() == 0 && (in_order || room);
  seen.may_ask = in_order ? may_ask_in_order(seen.command.is_long()) : true;
  seen.may_resynchronise =
      rules().numbered && recovery_.resynchronisations_in_a_row() < options_.resyncs_in_a_row_max;
  return seen;
}

void Session::ask(const SilenceWatch::Sight& sight, Instant now) {
  silence_.asked(now);
  if (!rules().numbered || sight.command.is_long()) {
    push_question(now);
  } else {
    ++statistics_.resyncs;
    put_forced_mismatch();
  }
}

bool Session::may_ask_in_order(bool behind_long) const {
  const int questions_max = rules().numbered && behind_long ? kQuestionsBehindLong : kQuestionsMax;
  return phase_ == Phase::kOpen && recovery_.in_step() && OrderedQuestions::fits(window_) &&
         OrderedQuestions::in_flight(window_) < questions_max;
}

// A line in its turn, before one that waits for room.
void Session::push_question(Instant now) {
  const std::int64_t at = window_.next_to_send();
  if (question_ && question_->sequence == at) ++question_->sequence;
  questions_.ask(window_);
  pump(now);
}

// Before the print, where few lines are sent.
void Session::ask_for_answer(Instant now) {
  signs_.expect_progress(now);
  if (window_.all_sent() && OrderedQuestions::in_flight(window_) < kQuestionsMax)
    push_question(now);
}

// Whether an `ok` can be told from others: to a question, or late to one.
bool Session::names_a_line(const Reply& reply) const {
  const bool warm = reply.temperatures.nozzle_celsius || reply.temperatures.bed_celsius;
  return warm && (OrderedQuestions::in_flight(window_) > 0 || !rules().numbered);
}

// All up to that line have been answered, whatever was heard of it.
void Session::acknowledge_through(std::int64_t sequence) {
  const bool missing = OrderedQuestions::acknowledge_through(window_, sequence);
  if (missing && !rules().numbered) answers_missing();
}

void Session::answers_missing() {
  if (state_ != SessionState::kStreaming && state_ != SessionState::kFinishing) return;
  if (rules().checksummed) {
    fault(FaultKind::kSilence,
          "the controller left a line without an answer: nobody can know whether it ran", true);
    return;
  }
  // The answer was lost, or the line itself; where the nozzle is, and how much filament it has
  // pushed, tells which.
  own_requests_.ask_position = true;
}

// Where nothing is checked on its way, a command that it does not know and that was never sent.
bool Session::damaged_by(const Reply& reply) const {
  if (phase_ != Phase::kOpen || !rules().macros || rules().numbered) return false;
  const std::size_t begin = reply.text.find('"');
  const std::size_t end = reply.text.rfind('"');
  if (begin == std::string_view::npos || end <= begin) return false;
  const std::string_view word = word_of(reply.text.substr(begin + 1, end - begin - 1));
  for (std::int64_t i = window_.acknowledged(); i < window_.next_to_send(); ++i) {
    if (word_of(window_.text(i)) == word) return false;
  }
  return true;
}

void Session::resynchronise(Instant now) {
  signs_.expect_answer(now);
  recovery_.resynchronises();
  put_forced_mismatch();
}

void Session::put_forced_mismatch() {
  if (!recovery_.asks()) {
    fault(FaultKind::kRefusals,
          "the controller does not count lines as a " + std::string(dialect().name()) +
              " does; it calls itself \"" + identity_.name() + "\"",
          true);
    return;
  }
  if (!output_.has_room_for(kLineBytesMax + 2)) return;
  LineBuffer buffer;
  packing_.stop(packing_sight(), output_);
  output_.put("\n");
  output_.put(number_line(kResyncLineNumber, kQuestion, buffer));
  output_.put("\n");
}

}  // namespace firmware_link
