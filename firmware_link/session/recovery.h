// How a session with numbered lines gets back in step with its controller.
//
//     in step ──Resend: k──> quiet ──100 ms without an answer──> in step, from line k
//        │                     ▲
//        └──forced mismatch──> asked ──Resend: k──┘              (a silence, a stop, an end)
//
// A forced mismatch is a line whose number is never the next. The controller does not run it, and
// answers with the last line that it accepted.
//
// A pure state machine: the session keeps the lines, and sends.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>

#include "firmware_link/session/account_watch.h"  // AccountWatch
#include "firmware_link/session/calm_lines.h"     // CalmLines
#include "firmware_link/wire/instant.h"           // Instant

namespace firmware_link {

class Recovery {
 public:
  explicit Recovery(Instant now) : quiet_since_(now) {}

  // --- what the controller says ---

  // A line was refused with these words. A request to repeat it and an `ok` follow.
  void refused(std::string_view words, Instant now) {
    skip_next_ok_ = true;
    quiet_since_ = now;
    accounts_.refused(words);
  }
  // A request for a line came. Its `ok` follows where lines are numbered.
  void resend_heard(bool numbered, Instant now) {
    skip_next_ok_ = numbered;
    quiet_since_ = now;
  }
  // Neither an `ok` nor a request for a line came, so the `ok` of a refused line got lost.
  void other_heard() { skip_next_ok_ = false; }
  // True when this `ok` belongs to a refused line.
  [[nodiscard]] bool skips_ok(Instant now);
  // An `ok` acknowledged a line, or would have.
  void ok_heard() {
    work_seen();
    calm_lines_.line_went_well();
  }
  // The controller says that it is working.
  void work_seen() { resynchronisations_in_a_row_ = asked_ ? 1 : 0; }

  // --- requests for a line ---

  // What to do about one for a line that cannot be the next.
  enum class Doubt {
    kIgnore,
    kAskAgain,
    kCounterJumped,  // the third that says the same: the controller counts wrong
  };
  [[nodiscard]] Doubt doubt(std::optional<std::int64_t> number);

  // One for a line that can be the next came, or a line of ours was acknowledged.
  void account_possible() { accounts_.possible(); }
  // `all_there`: the controller asks for the first line that was never sent, so it has all others.
  void account_told(bool all_there);

  // A line will be repeated; false when the controller has refused it more than `repeats_max`
  // times.
  [[nodiscard]] bool repeats(std::int64_t sequence, int repeats_max);
  [[nodiscard]] int repeats_of_a_line() const { return repeats_of_a_line_; }

  // Whether it is worth telling, once, how many of the lines sent were asked for again.
  [[nodiscard]] bool tells_frequent(std::int64_t lines_sent, double resend_ratio);

  // Lines may be sent when no answer has come for a while: each line that was in flight may be
  // refused on its own.
  void wait_for_quiet() { quiet_ = true; }
  // True once, when the wait is over. `all_written`: no byte waits for the port.
  [[nodiscard]] bool quiet_over(Duration quiet, bool all_written, Instant now);
  void bytes_left(Instant now) { quiet_since_ = std::max(quiet_since_, now); }

  // --- forced mismatches ---

  // One is sent; false when too many in a row have had no answer.
  [[nodiscard]] bool asks();
  void resynchronises() { ++resynchronisations_in_a_row_; }
  [[nodiscard]] int resynchronisations_in_a_row() const { return resynchronisations_in_a_row_; }
  // Whether the answer to one is waited for.
  [[nodiscard]] bool asked() const { return asked_; }
  void answered() { asked_ = false; }

  // The controller itself has said that it has every line, and nothing was sent since.
  [[nodiscard]] bool confirmed() const { return confirmed_; }
  void confirm() { confirmed_ = true; }
  void line_sent() { confirmed_ = false; }

  // --- the rest ---

  // Whether lines may be sent.
  [[nodiscard]] bool in_step() const { return !quiet_ && !asked_; }
  [[nodiscard]] bool waits_for_quiet() const { return quiet_; }
  [[nodiscard]] bool one_line_at_a_time() const { return calm_lines_.alone(); }

  // A greeting is sent. What was in flight before it has no answers any more.
  void greeting_sent() { skip_next_ok_ = false; }
  // Line numbers have started again.
  void numbers_restarted() { repeated_line_ = -1; }
  // The conversation starts again.
  void restart() { quiet_ = asked_ = skip_next_ok_ = false; }
  void dialect_found() { calm_lines_.forget(); }
  // The host stood still for so long.
  void bridge(Duration gap, Instant now) { quiet_since_ = std::min(now, quiet_since_ + gap); }

 private:
  AccountWatch accounts_;
  CalmLines calm_lines_;
  bool skip_next_ok_ = false;  // it belongs to a refused line
  bool quiet_ = false;         // waiting for quiet after a Resend
  Instant quiet_since_;        // the last answer that a refusal may have caused
  bool asked_ = false;         // a forced mismatch waits for its answer
  bool confirmed_ = false;
  int resynchronisations_in_a_row_ = 0;  // without success
  int mismatches_ = 0;                   // without the `Resend:` that answers them
  int repeats_of_a_line_ = 0;
  std::int64_t repeated_line_ = -1;
  bool told_frequent_ = false;
};

}  // namespace firmware_link
