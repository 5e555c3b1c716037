// What the session says of its own accord, and what it watches: temperatures, place, filament.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <variant>

#include "firmware_link/session/session.h"
#include "firmware_link/wire/check.h"
#include "firmware_link/wire/line_codec.h"  // write_fixed

namespace firmware_link {
namespace {

// The controller's count of filament is a float: it is set back to 0 before it gets coarse.
constexpr std::int64_t kFilamentCount10nmMax = 10'000'000;
// So many accounts in a row that agree neither with what was sent nor with one another are enough.
constexpr int kQuestionsMax = 8;
// How long nothing may be heard before temperatures are asked for, to see that it lives.
constexpr Duration kIdlePoll = std::chrono::seconds(10);

std::string mm_text(std::int64_t value_10nm) {
  char text[32];
  return std::string(text, write_fixed(text, value_10nm, 5));
}

}  // namespace

void Session::give(const Command& command, bool is_command, Instant now) {
  LINK_CHECK(can_take());
  if (is_command) ++statistics_.commands_taken;
  const auto* move = std::get_if<Move>(&command);
  if (rules().tells_position && move != nullptr && move->e_10nm && !position_.expected().e_10nm) {
    // From here on the controller's count of filament is to be known. Not earlier, because the
    // user's own lines may count in their own way.
    own_requests_.reset_filament = true;
    deferred_ = {command, is_command};
  } else {
    push_command(command, is_command);
  }
  pump(now);
}

void Session::push_command(const Command& command, bool is_command) {
  TextBuffer long_buffer;
  TextBuffer buffer;
  const std::string_view text = encode(command, long_buffer);
  LineEffort effort;
  if (const auto* move = std::get_if<Move>(&command)) {
    effort.nominal = position_.nominal_time(*move);
    effort.blocks = planner_blocks_of(*move);
    position_.gave(*move);
  } else if (std::holds_alternative<Verbatim>(command)) {
    position_.gave_unknown();
    if (word_of(text) == "M113") silence_.may_be_silent();
  }
  if (wait_of(text, rules().macros).planner_runs_empty) effort = kWaitsForPlanner;
  window_.push(shortened(text, buffer), is_command, effort);
}

void Session::push_own(std::string_view text, const LineEffort& effort) {
  window_.push(text, false, effort);
}

bool Session::own_line_due() const {
  if (phase_ != Phase::kOpen) return false;
  if (state_ != SessionState::kStreaming && state_ != SessionState::kFinishing) return false;
  return own_requests_.feed_percent || own_requests_.flow_percent ||
         own_requests_.filament_correction_10nm || own_requests_.reset_filament ||
         own_requests_.ask_temperatures || own_requests_.report_temperatures ||
         own_requests_.stay_awake || (own_requests_.ask_position && !question_);
}

// Puts the most pressing one of the own lines into the window; false when there is none.
bool Session::push_own_line(Instant now) {
  if (!own_line_due()) return false;
  if (confirming_ && rules().numbered && !recovery_.confirmed()) {
    // Only when the controller itself says that it has every line, and no more, is what it tells
    // of its place the answer to this question.
    if (window_.lines_in_flight() == 0 && !recovery_.asked()) resynchronise(now);
    return false;
  }
  if (own_requests_.feed_percent) {
    push_own("M220 S" + std::to_string(*own_requests_.feed_percent));
    own_requests_.feed_percent.reset();
  } else if (own_requests_.flow_percent) {
    push_own("M221 S" + std::to_string(*own_requests_.flow_percent));
    own_requests_.flow_percent.reset();
  } else if (own_requests_.filament_correction_10nm) {
    push_own("G1 E" + mm_text(*own_requests_.filament_correction_10nm));
    own_requests_.filament_correction_10nm.reset();
  } else if (own_requests_.reset_filament) {
    // Nothing goes behind it: the tail of a line cut there would run before the count begins.
    push_own("G92 E0", kGoesAlone);
    own_requests_.ask_position = true;
    position_.gave_filament_reset();
    own_requests_.reset_filament = false;
  } else if (own_requests_.ask_position && !question_) {
    question_ = PositionQuestion{window_.end(), position_.expected(), std::nullopt};
    if (rules().height_may_shift) question_->expected.axes_um[2].reset();
    // Where the count has just begun, its `ok` is also the sign that the G92 before it was not
    // itself such a tail.
    push_own("M114", position_.expected().moves == 0 ? kGoesAlone : LineEffort{});
    own_requests_.ask_position = false;
  } else if (own_requests_.report_temperatures) {
    const auto interval =
        std::chrono::duration_cast<std::chrono::seconds>(options_.temperature_interval).count();
    push_own("M155 S" + std::to_string(std::clamp<std::int64_t>(interval, 1, 60)));
    own_requests_.report_temperatures = false;
  } else if (own_requests_.stay_awake) {
    // Waits for a millisecond, and moves nothing.
    push_own("G4 P1", kWaitsForPlanner);
    own_requests_.stay_awake = false;
  } else {
    push_own("M105");
    own_requests_.ask_temperatures = false;
  }
  return true;
}

void Session::tick_watch(Instant now) {
  if (phase_ != Phase::kOpen || state_ != SessionState::kStreaming) return;
  if (rules().keep_awake.count() > 0 && holding_ && window_.lines_in_flight() == 0 &&
      now - last_awake_ >= rules().keep_awake) {
    last_awake_ = now;
    own_requests_.stay_awake = true;
  }
  const Duration interval = options_.temperature_interval;
  if (interval.count() <= 0) return;
  const bool polls =
      !identity_.capabilities().autoreport_temperatures && now - last_polled_ >= interval;
  const bool idle =
      window_.lines_in_flight() == 0 && now - std::max(signs_.byte(), last_polled_) >= kIdlePoll;
  if (!polls && !idle) return;
  last_polled_ = now;
  own_requests_.ask_temperatures = true;
}

void Session::check_position(Instant now) {
  if (!rules().tells_position || state_ != SessionState::kStreaming) return;
  own_requests_.ask_position = true;
  pump(now);
}

void Session::set_feed_percent(int percent, Instant now) {
  LINK_CHECK(percent >= 10 && percent <= 500);
  own_requests_.feed_percent = percent;
  pump(now);
}

void Session::set_flow_percent(int percent, Instant now) {
  LINK_CHECK(percent >= 10 && percent <= 500);
  own_requests_.flow_percent = percent;
  pump(now);
}

void Session::hold(bool holding, Instant now) {
  holding_ = holding;
  planner_.expect_gap(now);
}

// An account that was asked for is complete when its `ok` has come. A difference is believed when
// two accounts in a row, with no move between them, say the same: an account may be damaged as any
// answer may. And an `ok` too many, such as the tail of a cut line gets, makes every answer seem to
// come late: the account before, or none.
void Session::settle_position() {
  if (!question_ || window_.acknowledged() <= question_->sequence) return;
  const PositionQuestion question = *question_;
  question_.reset();
  auto verdict = PositionWatch::Verdict::kAgrees;
  if (question.told) {
    ++statistics_.positions_checked;
    verdict = PositionWatch::compare(question.expected, *question.told);
    if (verdict == PositionWatch::Verdict::kAgrees) {
      end_confirming();
      const auto count = position_.expected().e_10nm;
      if (count && std::abs(*count) > kFilamentCount10nmMax) own_requests_.reset_filament = true;
      return;
    }
  }
  if (!question.told || !confirming_ || !told_last_ || !(*told_last_ == *question.told)) {
    if (++questions_in_a_row_ >= kQuestionsMax) {
      end_confirming();
      warn("its position could not be confirmed: each answer to M114 was another");
      return;
    }
    confirming_ = true;
    told_last_ = question.told;
    own_requests_.ask_position = true;
    return;
  }
  end_confirming();
  if (verdict == PositionWatch::Verdict::kPositionDiffers) {
    fault(FaultKind::kPosition,
          "the controller is not where it was sent: at " + PositionWatch::text_of(*question.told) +
              ", not " + PositionWatch::text_of(question.expected),
          true);
    return;
  }
  filament_differs(PositionWatch::filament_excess_10nm(question.expected, *question.told));
}

void Session::end_confirming() {
  confirming_ = false;
  told_last_.reset();
  questions_in_a_row_ = 0;
}

void Session::filament_differs(std::int64_t excess_10nm) {
  const std::string what = mm_text(std::abs(excess_10nm)) + " mm of filament " +
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
  own_requests_.filament_correction_10nm = -excess_10nm;
  events_.push(SessionEvent::Kind::kFilamentCorrected, what);
}

void Session::note_temperatures(const Reply& reply, Instant now) {
  Temperatures& known = statistics_.temperatures;
  const Temperatures& heard = reply.temperatures;
  const auto update = [](std::optional<double>& kept, const std::optional<double>& value) {
    if (value) kept = value;
  };
  update(known.nozzle_celsius, heard.nozzle_celsius);
  update(known.nozzle_target_celsius, heard.nozzle_target_celsius);
  update(known.bed_celsius, heard.bed_celsius);
  update(known.bed_target_celsius, heard.bed_target_celsius);
  if (state_ != SessionState::kStreaming && state_ != SessionState::kFinishing) return;
  std::optional<std::string> complaint;
  if (heard.nozzle_celsius && heard.nozzle_target_celsius) {
    complaint = nozzle_watch_.heard(*heard.nozzle_celsius, *heard.nozzle_target_celsius, now);
  }
  if (!complaint && heard.bed_celsius && heard.bed_target_celsius) {
    complaint = bed_watch_.heard(*heard.bed_celsius, *heard.bed_target_celsius, now);
  }
  if (complaint) fault(FaultKind::kHeater, *complaint, true);
}

void Session::note_action(std::string_view action) {
  using Kind = SessionEvent::Kind;
  struct Known {
    std::string_view words;
    Kind kind;
  };
  constexpr Known kKnown[] = {{"pause", Kind::kPauseAsked},
                              {"resume", Kind::kResumeAsked},
                              {"cancel", Kind::kCancelAsked},
                              {"paused", Kind::kPaused},
                              {"resumed", Kind::kResumed}};
  for (const Known& known : kKnown) {
    if (action == known.words) {
      events_.push(known.kind, std::string(action));
      return;
    }
  }
  events_.push(Kind::kAction, std::string(action));
}

void Session::warn(std::string_view words) {
  ++statistics_.warnings;
  last_warning_ = std::string(words);
  events_.push(SessionEvent::Kind::kWarning, last_warning_);
}

}  // namespace firmware_link
