// The half of the session that speaks: which line goes next, and when.
#include <algorithm>
#include <chrono>
#include <string>
#include <variant>

#include "firmware_link/session/session.h"
#include "firmware_link/wire/check.h"
#include "firmware_link/wire/line_codec.h"  // encode, number_line

namespace firmware_link {
namespace {

// So much motion in the planner is enough for the next line to come in time: far more than an
// answer takes on its way (16 ms are found), and Marlin slows no segment down that leaves half of
// its planner so long (8 blocks of 20 ms).
constexpr Duration kPlannerFed = std::chrono::milliseconds(200);

// Read before its turn, as M112 is: ends M109, M190, M0. Never M410, which kills a homing Marlin.
constexpr std::string_view kWaitNoMore = "\nM108\n";

// A forced mismatch with its ends of line.
constexpr std::size_t kMismatchBytes = 19;

// Questions in flight, at most: behind a command that takes long they take up command slots.
constexpr int kQuestionsBehindLong = 2;
constexpr int kQuestionsMax = 4;

}  // namespace

// Moves to the next state when all that this one waits for is there.
void Session::settle(Instant now) {
  const bool may_settle = phase_ == Phase::kAsking || phase_ == Phase::kOpen;
  if (ended() || shutdown_.awaited() || !may_settle) return;
  const bool idle = window_.all_sent() && window_.lines_in_flight() == 0 && !recovery_.asked() &&
                    !own_line_due() && !position_.in_flight() && !deferred_;
  if (phase_ == Phase::kAsking && idle && !settle_asking(now)) return;
  if (!recovery_.in_step() || window_.lines_in_flight() > 0) return;

  const bool out_of_numbers = rules().numbered && !window_.all_sent() &&
                              window_.number_of(window_.next_to_send()) > options_.line_number_max;
  const bool finishing = state_ == SessionState::kFinishing && idle;
  const bool stopping =
      state_ == SessionState::kStopping && idle && stop_.has_start() && stop_.all_taken();
  if (!out_of_numbers && !finishing && !stopping) return;
  if (rules().numbered && !recovery_.confirmed()) {
    resynchronise(now);
  } else if (finishing || stopping) {
    state_ = finishing ? SessionState::kFinished : SessionState::kStopped;
  } else {
    greeting_.forget_count();
    greet(now);
  }
}

// What asks for the controller's name has been answered, to its `ok`. True when it is ready.
bool Session::settle_asking(Instant now) {
  if (identity_.doubts_name()) {
    push_own("M115");
    pump(now);
    return false;
  }
  const bool settles = identity_.adopt_dialect();
  events_.push(SessionEvent::Kind::kDialect, std::string(dialect().name()));
  recovery_.dialect_found();
  if (settles) {
    phase_ = Phase::kSettling;
    greeting_.next_phase(now);
    return false;
  }
  start_readying(now);
  return phase_ == Phase::kOpen;
}

// Sends as many lines as may leave now.
void Session::pump(Instant now) {
  const bool talks =
      phase_ == Phase::kAsking || phase_ == Phase::kReadying || phase_ == Phase::kOpen;
  if (ended() || shutdown_.awaited() || !talks) return;
  if (state_ == SessionState::kStopping && !stop_.has_start()) {
    if (!recovery_.asked() && phase_ == Phase::kOpen) resynchronise(now);
    return;
  }
  while (recovery_.in_step() && send_next(now)) {
  }
}

// True when a line has left.
bool Session::send_next(Instant now) {
  if (!has_next_line(now)) return false;
  const std::int64_t sequence = window_.next_to_send();
  if (rules().numbered && window_.number_of(sequence) > options_.line_number_max) {
    settle(now);
    return false;
  }
  const bool ahead = questions_.goes_ahead(window_, sequence);
  if (!ahead && !goes_behind_others(sequence, now)) return false;
  if (!output_.has_room_for(2 * kLineBytesMax)) return false;
  return put_line(sequence, ahead, now);
}

// Sees to it that the window holds a line to be sent: the link's own lines first, then the command
// that waited for them, then the safe sequence of a stop. False when there is none.
bool Session::has_next_line(Instant now) {
  if (!window_.all_sent() || push_own_line(now)) return true;
  if (own_line_due()) return false;
  if (deferred_) {
    push_command(deferred_->command, deferred_->is_command);
    deferred_.reset();
    return true;
  }
  if (state_ != SessionState::kStopping || stop_.all_taken()) return false;
  push_own(stop_.take());
  return true;
}

// A command that waits goes when all before it have been answered, so that an answer behind its
// signs of work is its own. Where no checksum shows that two lines have run together, only moves go
// behind others: that one is gone shows in the position and the filament. Any other line goes
// behind an `ok`, on a line of its own.
bool Session::goes_behind_others(std::int64_t sequence, Instant now) const {
  if (window_.lone_line_in_flight()) return false;
  // One line at a time where that is enough: what a flush cuts is then never a line of ours.
  const bool alone =
      recovery_.one_line_at_a_time() || (rules().numbered && planner_.end() - now >= kPlannerFed);
  if (window_.lines_in_flight() >= (alone ? 1 : rules().window_lines)) return false;
  if (window_.lines_in_flight() == 0 || state_ == SessionState::kStopping) return true;
  if (window_.effort(sequence).goes_alone) return false;
  if (rules().numbered) return true;
  const std::string_view word = word_of(window_.text(sequence));
  return word == "G0" || word == "G1" || word == "M105";
}

// True when the line has left.
bool Session::put_line(std::int64_t sequence, bool ahead, Instant now) {
  LineBuffer buffer;
  const std::int64_t number = window_.number_of(sequence);
  // Where nothing is repeated, numbers only have to be some.
  const auto shown = static_cast<std::int32_t>(
      rules().numbered ? number : std::max<std::int64_t>(0, number) % kLineNumberMax);
  const std::string_view line = rules().numbered || rules().checksummed
                                    ? number_line(shown, window_.next_text(), buffer)
                                    : window_.next_text();
  LINK_CHECK(line.size() <= kLineBytesMax);
  if (!packing_.may_send(packing_sight(), now, output_)) return false;
  PackedBuffer packed;
  const auto wire = packing_.bytes_of(line, packing_sight(), packed, output_);
  if (!wire) return false;
  if (!ahead && window_.bytes_in_flight() + wire->size() > rules().window_bytes) return false;
  if (window_.lines_in_flight() == 0) signs_.expect_answer(now);
  if (sequence < window_.sent_end()) ++statistics_.lines_repeated;
  output_.put(*wire);
  window_.sent(wire->size());
  recovery_.line_sent();
  ++statistics_.lines_sent;
  statistics_.lines_packed += packing_.on() ? 1 : 0;
  statistics_.lines_in_flight_max =
      std::max(statistics_.lines_in_flight_max, window_.lines_in_flight());
  statistics_.bytes_in_flight_max =
      std::max(statistics_.bytes_in_flight_max, window_.bytes_in_flight());
  return true;
}

Packing::Sight Session::packing_sight() const {
  Packing::Sight sight;
  // A damaged line must be found by its checksum.
  sight.allowed = options_.pack && identity_.capabilities().meatpack && rules().numbered &&
                  phase_ == Phase::kOpen;
  sight.calm = state_ == SessionState::kStreaming && !recovery_.one_line_at_a_time();
  sight.next_to_send = window_.next_to_send();
  sight.sent_end = window_.sent_end();
  sight.in_flight = window_.lines_in_flight() > 0;
  return sight;
}

bool Session::own_line_due() const {
  if (phase_ != Phase::kOpen) return false;
  if (state_ != SessionState::kStreaming && state_ != SessionState::kFinishing) return false;
  return requests_.due(position_.in_flight().has_value());
}

// Puts the most pressing one of the link's own lines into the window; false when there is none.
bool Session::push_own_line(Instant now) {
  if (!own_line_due()) return false;
  if (position_.confirming() && rules().numbered && !recovery_.confirmed()) {
    // Only when the controller itself says that it has every line, and no more, is what it tells
    // of its position the answer to this question.
    if (window_.lines_in_flight() == 0 && !recovery_.asked()) resynchronise(now);
    return false;
  }
  const bool count_is_new = position_.watch().expected().moves == 0;
  const OwnRequests::Line line = requests_.take(position_.in_flight().has_value(), count_is_new);
  if (line.kind == OwnRequests::Line::Kind::kFilamentReset) position_.watch().gave_filament_reset();
  if (line.kind == OwnRequests::Line::Kind::kPosition) {
    position_.asked(window_.end(), rules().height_may_shift);
  }
  push_own(line.text, line.effort);
  return true;
}

void Session::push_own(std::string_view text, const LineEffort& effort) {
  window_.push(text, false, effort);
}

void Session::push_command(const Command& command, bool is_command) {
  TextBuffer long_buffer;
  TextBuffer buffer;
  const std::string_view text = encode(command, long_buffer);
  LineEffort effort;
  const auto* ready = std::get_if<ReadyLine>(&command);
  if (const Move* move = move_of(command)) {
    effort.nominal = position_.watch().nominal_time(*move);
    effort.blocks = planner_blocks_of(*move);
    position_.watch().gave(*move);
  }
  if (ready != nullptr) position_.watch().gave_ready(*ready, options_.count_filament);
  if (std::holds_alternative<Verbatim>(command)) position_.watch().gave_unknown();
  const bool words = ready != nullptr || std::holds_alternative<Verbatim>(command);
  if (words && word_of(text) == "M113") silence_.may_be_silent();
  if (wait_of(text, rules().macros).planner_runs_empty) effort = kWaitsForPlanner;
  window_.push(ready != nullptr ? text : shortened(text, buffer), is_command, effort);
}

// --- what the controller told of its position ---

void Session::settle_position() {
  const PositionCheck::Result result = position_.settle(window_.acknowledged());
  if (result.told) ++statistics_.positions_checked;
  switch (result.outcome) {
    case PositionCheck::Outcome::kNone:
      return;
    case PositionCheck::Outcome::kAgrees:
      if (position_.count_is_coarse()) requests_.reset_filament();
      return;
    case PositionCheck::Outcome::kAskAgain:
      requests_.ask_position();
      return;
    case PositionCheck::Outcome::kUnconfirmed:
      warn("its position could not be confirmed: each answer to M114 was another");
      return;
    case PositionCheck::Outcome::kPositionDiffers:
      fault(FaultKind::kPosition, "the controller is not where it was sent: " + result.words, true);
      return;
    case PositionCheck::Outcome::kFilamentDiffers:
      correct_filament(result.excess_10nm);
      return;
  }
}

void Session::correct_filament(std::int64_t excess_10nm) {
  const std::string what = filament_text(std::abs(excess_10nm)) + " mm of filament " +
                           (excess_10nm > 0 ? "too much" : "too little");
  // Where nothing is repeated, a line that left filament out is gone, its road with it.
  if (!rules().numbered || std::abs(excess_10nm) > options_.filament_correction_10nm_max ||
      statistics_.filament_corrections >= options_.filament_corrections_max) {
    fault(FaultKind::kPosition,
          "the controller has counted " + what +
              ": lines were damaged, or it does not count each move's filament by itself",
          true);
    return;
  }
  ++statistics_.filament_corrections;
  requests_.correct_filament(-excess_10nm);
  events_.push(SessionEvent::Kind::kFilamentCorrected, what);
}

// --- an answer is missing ---
//
// Two questions. A forced mismatch runs nothing and is answered before its turn, with the last line
// that was accepted: where lines are numbered, and a command that is answered at once is in flight.
// An M105 behind all that is in flight is answered in its turn (ordered_questions.h): where nothing
// is numbered, and behind a command that takes long, which was accepted long before it ends.

SilenceWatch::Sight Session::silence_sight(Instant now) const {
  SilenceWatch::Sight sight;
  if (window_.lines_in_flight() > 0) {
    sight.head = window_.acknowledged();
    sight.text = window_.text(sight.head);
  }
  // What takes longest is what is waited for.
  for (std::int64_t i = window_.acknowledged(); i < window_.next_to_send(); ++i) {
    const CommandWait wait = wait_of(window_.text(i), rules().macros);
    if (wait.limit <= sight.command.limit) continue;
    sight.command = wait;
    sight.text = window_.text(i);
  }
  // The lines of a stop wait behind it.
  if (stop_.behind() && options_.long_stop_limit > sight.command.limit) {
    sight.command = {"a command that a stop waits for", options_.long_stop_limit, true};
    sight.text = *stop_.behind();
  }
  sight.last_life = signs_.sense();
  sight.last_progress = signs_.progress();
  sight.planner_time = std::max(Duration(0), planner_.end() - now);
  sight.questions = OrderedQuestions::in_flight(window_);
  const std::size_t bytes = kMismatchBytes * static_cast<std::size_t>(silence_.asks() + 1);
  const bool room = window_.bytes_in_flight() + bytes <= kWindowBytesMax;
  const bool in_order = !rules().numbered || sight.command.is_long();
  sight.stands = phase_ == Phase::kOpen && planner_.blocks() == 0 && (in_order || room);
  sight.may_ask = in_order ? may_ask_in_order(sight.command.is_long()) : true;
  sight.may_resynchronise =
      rules().numbered && recovery_.resynchronisations_in_a_row() < options_.resyncs_in_a_row_max;
  return sight;
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

void Session::push_question(Instant now) {
  position_.moved_back(window_.next_to_send());
  questions_.ask(window_);
  pump(now);
}

// Before the print, where few lines are sent.
void Session::ask_for_answer(Instant now) {
  signs_.expect_progress(now);
  const bool room = OrderedQuestions::in_flight(window_) < kQuestionsMax;
  if (window_.all_sent() && room) push_question(now);
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
  output_.put(number_line(kResyncLineNumber, "M105", buffer));
  output_.put("\n");
}

// In plain characters, as whatever acts before its turn.
void Session::put_wait_no_more() {
  if (packing_.may_unpack()) packing_.stop(packing_sight(), output_);
  output_.put(kWaitNoMore);
}

}  // namespace firmware_link
