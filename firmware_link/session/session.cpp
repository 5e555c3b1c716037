#include "firmware_link/session/session.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "firmware_link/wire/check.h"
#include "firmware_link/wire/line_codec.h"  // encode, number_line

namespace firmware_link {
namespace {

// So much motion in the planner is enough for the next line to come in time: far more than an
// answer takes on its way (16 ms are found), and Marlin slows no segment down that leaves half of
// its planner so long (8 blocks of 20 ms).
constexpr Duration kPlannerFed = std::chrono::milliseconds(200);

// What cannot come out of a damaged line, and stops at once any garbage before it.
constexpr std::string_view kEmergencyStop = "\nM112\n";

// Read before its turn, as M112 is: ends M109, M190, M0. Never M410, which kills a homing Marlin.
constexpr std::string_view kWaitNoMore = "\nM108\n";

}  // namespace

Session::Session(std::unique_ptr<Dialect> dialect, const SessionOptions& options, Instant now)
    : identity_(std::move(dialect)),
      options_(options),
      signs_(now),
      greeting_(now),
      recovery_(now),
      silence_(options_.wait_limit),
      stop_began_(now),
      last_polled_(now) {
  LINK_CHECK(options_.line_number_max >= 1 && options_.line_number_max <= kLineNumberMax);
}

bool Session::can_take() const {
  return state_ == SessionState::kStreaming && window_.all_sent() && !own_line_due() &&
         !confirming_ && !deferred_ && !shutdown_.awaited();
}

void Session::take(const Command& command, Instant now) { give(command, true, now); }

void Session::insert(const Command& command, Instant now) { give(command, false, now); }

std::int32_t Session::accepted_line() const {
  return static_cast<std::int32_t>(
      std::max<std::int64_t>(0, window_.number_of(window_.acknowledged()) - 1));
}

std::optional<std::int64_t> Session::commands_through_line(std::int32_t line) const {
  const std::int64_t sequence = window_.sequence_of(line) + 1;
  if (sequence < window_.oldest() || sequence > window_.end()) return std::nullopt;
  return window_.commands_before(sequence);
}

void Session::finish(Instant now) {
  LINK_CHECK(state_ == SessionState::kStreaming);
  state_ = SessionState::kFinishing;
  settle(now);
}

std::span<const std::byte> Session::output() const { return output_.pending(); }

void Session::written(std::size_t count, Instant now) {
  bridge_gap(now);
  output_.written(count);
  statistics_.bytes_sent += static_cast<std::int64_t>(count);
  // Quiet counts from when the last byte left, so that its answer can come.
  if (output_.empty() && count > 0) recovery_.bytes_left(now);
}

void Session::tick(Instant now) {
  bridge_gap(now);
  if (ended()) return;
  if (shutdown_.awaited()) {
    tick_shut_down(now);
    return;
  }
  planner_.advance(now);
  if (phase_ == Phase::kBanner || phase_ == Phase::kGreeting || phase_ == Phase::kSettling) {
    tick_greeting(now);
  } else if (phase_ == Phase::kReadying) {
    tick_readying(now);
  } else {
    if (recovery_.quiet_over(rules().quiet_after_resend, output_.empty(), now)) {
      if (packing_.may_unpack()) packing_.stop(packing_sight(), output_);
      signs_.expect_answer(now);
    }
    tick_asking(now);
    packing_.tick(packing_sight(), now, output_);
    tick_silence(now);
    tick_watch(now);
  }
  if (state_ == SessionState::kStopping) tick_stop(now);
  settle(now);
  pump(now);
}

void Session::stop_now(std::span<const Command> safe_sequence, Instant now) {
  LINK_CHECK(safe_sequence.size() <= kSafeSequenceMax);
  if (state_ == SessionState::kStopping || state_ == SessionState::kStopped) return;
  safe_count_ = safe_sequence.size();
  safe_next_ = 0;
  for (std::size_t i = 0; i < safe_count_; ++i) {
    safe_sizes_[i] = static_cast<std::uint8_t>(encode(safe_sequence[i], safe_texts_[i]).size());
  }
  own_requests_ = {};
  deferred_.reset();
  question_.reset();
  end_confirming();
  if (state_ == SessionState::kConnecting || state_ == SessionState::kFaulted) {
    if (controller_may_live_) put_safe_sequence();
    listens_ = controller_may_live_;
    if (state_ == SessionState::kConnecting) state_ = SessionState::kStopped;
    return;
  }
  state_ = SessionState::kStopping;
  stop_began_ = now;
  note_stop_behind(now);
  window_.drop_never_sent();
  // What waits for heat or for a user waits no longer; its own `ok` is met by the forced mismatch.
  if (rules().numbered && window_.lone_line_in_flight()) put_wait_no_more();
  // Which of the sent lines are accepted decides where the safe sequence begins: a line with a
  // number that the controller already has would be dropped in silence.
  if (rules().numbered) {
    if (phase_ == Phase::kOpen) resynchronise(now);
  } else {
    end_of_commands_ = window_.end();
  }
  pump(now);
}

void Session::answer_user(Instant now) {
  if (!waits_for_user_ || !rules().numbered || phase_ != Phase::kOpen) return;
  put_wait_no_more();
  waits_for_user_ = false;
  signs_.expect_sense(now);
}

void Session::port_lost(const std::string& reason) {
  if (!ended()) fault(FaultKind::kPortLost, reason, false);
}

SessionStatistics Session::statistics() const {
  SessionStatistics now = statistics_;
  now.commands_sent = window_.commands_before(window_.sent_end());
  now.commands_acknowledged = accepted();
  now.events_dropped = events_.dropped();
  now.planner_low_s = std::chrono::duration<double>(planner_.low()).count();
  now.lines_in_flight = window_.lines_in_flight();
  now.bytes_in_flight = window_.bytes_in_flight();
  now.replies_cut = splitter_.lines_cut();
  return now;
}

bool Session::ended() const {
  return state_ == SessionState::kFaulted || state_ == SessionState::kFinished ||
         state_ == SessionState::kStopped;
}

void Session::fault(FaultKind kind, const std::string& why, bool controller_may_live) {
  fault_kind_ = kind;
  state_ = SessionState::kFaulted;
  reason_ = why;
  controller_may_live_ = controller_may_live;
  output_.clear();
}

// In plain characters, as whatever acts before its turn.
void Session::put_wait_no_more() {
  if (packing_.may_unpack()) packing_.stop(packing_sight(), output_);
  output_.put(kWaitNoMore);
}

void Session::put_safe_sequence() {
  if (packing_.may_unpack()) output_.put(kMeatPackReset);
  output_.put("\n");
  std::size_t bytes = 1;
  for (std::size_t i = 0; i < safe_count_; ++i) {
    const std::string_view text(safe_texts_[i].data(), safe_sizes_[i]);
    bytes += text.size() + 1;
    if (bytes > kWindowBytesMax) break;
    output_.put(text);
    output_.put("\n");
  }
  // Its answer tells that all before it was obeyed.
  output_.put("M105\n");
}

// Moves to the next state when all that this one waits for is there.
void Session::settle(Instant now) {
  if (ended() || shutdown_.awaited() || (phase_ != Phase::kAsking && phase_ != Phase::kOpen))
    return;
  const bool idle = window_.all_sent() && window_.lines_in_flight() == 0 && !recovery_.asked() &&
                    !own_line_due() && !question_ && !deferred_;
  if (phase_ == Phase::kAsking && idle) {
    if (asks_name_again(now)) return;
    if (adopt_dialect()) {
      phase_ = Phase::kSettling;
      greeting_.next_phase(now);
      return;
    }
    start_readying(now);
    if (phase_ != Phase::kOpen) return;
  }
  if (!recovery_.in_step() || window_.lines_in_flight() > 0) return;

  const bool out_of_numbers = rules().numbered && !window_.all_sent() &&
                              window_.number_of(window_.next_to_send()) > options_.line_number_max;
  const bool finishing = state_ == SessionState::kFinishing && idle;
  const bool stopping =
      state_ == SessionState::kStopping && idle && end_of_commands_ && safe_next_ == safe_count_;
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

void Session::pump(Instant now) {
  if (ended() || shutdown_.awaited() || !talks()) return;
  if (state_ == SessionState::kStopping && !end_of_commands_) {
    if (!recovery_.asked() && phase_ == Phase::kOpen) resynchronise(now);
    return;
  }
  while (recovery_.in_step() && send_next(now)) {
  }
}

bool Session::send_next(Instant now) {
  if (window_.all_sent() && !push_own_line(now)) {
    if (own_line_due()) return false;
    if (deferred_) {
      push_command(deferred_->command, deferred_->is_command);
      deferred_.reset();
      return send_next(now);
    }
    if (state_ != SessionState::kStopping || safe_next_ == safe_count_) return false;
    push_own({safe_texts_[safe_next_].data(), safe_sizes_[safe_next_]});
    ++safe_next_;
  }
  const std::int64_t sequence = window_.next_to_send();
  const std::int64_t number = window_.number_of(sequence);
  if (rules().numbered && number > options_.line_number_max) {
    settle(now);
    return false;
  }
  LineBuffer buffer;
  // Where nothing is repeated, numbers only have to be some.
  const auto shown = static_cast<std::int32_t>(
      rules().numbered ? number : std::max<std::int64_t>(0, number) % kLineNumberMax);
  const std::string_view line = rules().numbered || rules().checksummed
                                    ? number_line(shown, window_.next_text(), buffer)
                                    : window_.next_text();
  LINK_CHECK(line.size() <= kLineBytesMax);
  const bool ahead = questions_.goes_ahead(window_, sequence);
  if (!ahead && !goes_behind_others(sequence)) return false;
  if (!ahead && (window_.lines_in_flight() >= window_lines(now) || window_.lone_line_in_flight())) {
    return false;
  }
  if (!output_.has_room_for(2 * kLineBytesMax)) return false;
  if (!packing_.may_send(packing_sight(), now, output_)) return false;
  PackedBuffer packed;
  const auto wire = packing_.bytes_of(line, packing_sight(), packed, output_);
  if (!wire) return false;
  const std::size_t bytes = wire->size();
  if (!ahead && window_.bytes_in_flight() + bytes > rules().window_bytes) return false;
  if (window_.lines_in_flight() == 0) signs_.expect_answer(now);
  if (sequence < window_.sent_end()) ++statistics_.lines_repeated;
  output_.put(*wire);
  ++statistics_.lines_sent;
  statistics_.lines_packed += packing_.on() ? 1 : 0;
  window_.sent(bytes);
  recovery_.line_sent();
  statistics_.lines_in_flight_max =
      std::max(statistics_.lines_in_flight_max, window_.lines_in_flight());
  statistics_.bytes_in_flight_max =
      std::max(statistics_.bytes_in_flight_max, window_.bytes_in_flight());
  return true;
}

// A command that waits goes when all before it have been answered, so that an answer behind its
// signs of work is its own. Where no checksum shows that two lines have run together, only moves go
// behind others: that one is gone shows in the place and the filament. Any other line begins behind
// an `ok`, on a line of its own.
bool Session::goes_behind_others(std::int64_t sequence) const {
  if (window_.lines_in_flight() == 0 || state_ == SessionState::kStopping) return true;
  if (window_.effort(sequence).goes_alone) return false;
  if (rules().numbered) return true;
  const std::string_view word = word_of(window_.text(sequence));
  return word == "G0" || word == "G1" || word == "M105";
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

// One line at a time where that is enough: what a flush cuts is then never a line of ours.
std::size_t Session::window_lines(Instant now) const {
  if (recovery_.one_line_at_a_time()) return 1;
  if (rules().numbered && planner_.end() - now >= kPlannerFed) return 1;
  return rules().window_lines;
}

std::span<const std::byte> emergency_stop_bytes() {
  return std::as_bytes(std::span(kEmergencyStop.data(), kEmergencyStop.size()));
}

}  // namespace firmware_link
