// Questions that a controller answers in their turn: an M105 behind all that is in flight. Its `ok`
// carries temperatures, so it can be told from every other `ok`, and it shows that all lines before
// it have been answered.
//
//     in flight   G1 …   G1 …   M105          heard   ok   (lost)   "ok T:20.0 /0.0"
//                                                     └────── both G1 are done ──┘
#pragma once

#include <cstdint>
#include <optional>

#include "firmware_link/session/send_window.h"  // SendWindow

namespace firmware_link {

class OrderedQuestions {
 public:
  [[nodiscard]] static bool is_question(const SendWindow& window, std::int64_t sequence);
  [[nodiscard]] static int in_flight(const SendWindow& window);

  // Whether one more may be asked without a line in its way that was sent before.
  [[nodiscard]] static bool fits(const SendWindow& window);

  // Puts a question before a line that waits for room. REQUIRES: as SendWindow::push_ahead().
  void ask(SendWindow& window);

  // Whether no window holds that line back: it is a question, sent or repeated. The lines before it
  // have been accepted.
  [[nodiscard]] bool goes_ahead(const SendWindow& window, std::int64_t sequence) const {
    return sequence <= last_asked_ && is_question(window, sequence);
  }

  // An `ok` with temperatures came: the question that it answers. Where several questions stand
  // together it is the last of them, because no other line lies between. nullopt: the answer is
  // late, to a question that was taken to be lost.
  [[nodiscard]] std::optional<std::int64_t> answered(const SendWindow& window);

  // An `ok` came that could not be told from others.
  void plain_ok_heard() { late_answers_ = 0; }

  // Acknowledges all lines up to that one; true when one of them was no question, so that its own
  // answer is missing.
  [[nodiscard]] static bool acknowledge_through(SendWindow& window, std::int64_t sequence);

 private:
  std::int64_t last_asked_ = -1;
  int late_answers_ = 0;  // to questions that were taken to be lost
};

}  // namespace firmware_link
