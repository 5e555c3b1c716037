// The lines between "taken" and "forgotten": which are to be sent, which are in flight, which can
// still be repeated, and how many of the host's commands are among them. A pure state machine; it
// knows sequence numbers and line numbers, no wire format.
//
//     forgotten │ acknowledged, kept │ in flight   │ sent before, or new │
//     ──────────┼────────────────────┼─────────────┼─────────────────────┼──> sequence number
//            oldest()         acknowledged()  next_to_send()            end()
//
// restart(k) moves next_to_send() to k. An acknowledgement of k or a later line was false, so
// acknowledged() moves back to k, too. Lines before k stay in flight: their answers are still to
// come.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "firmware_link/session/line_effort.h"  // LineEffort
#include "firmware_link/wire/limits.h"          // kHistoryLinesMax
#include "firmware_link/wire/line_codec.h"      // TextBuffer

namespace firmware_link {

class SendWindow {
 public:
  [[nodiscard]] std::int64_t oldest() const { return oldest_; }
  [[nodiscard]] std::int64_t acknowledged() const { return acknowledged_; }
  [[nodiscard]] std::int64_t next_to_send() const { return next_to_send_; }
  [[nodiscard]] std::int64_t end() const { return end_; }

  [[nodiscard]] std::size_t lines_in_flight() const {
    return static_cast<std::size_t>(next_to_send_ - acknowledged_);
  }
  [[nodiscard]] std::size_t bytes_in_flight() const { return bytes_in_flight_; }
  [[nodiscard]] bool all_sent() const { return next_to_send_ == end_; }

  // Adds a line behind all others; `is_command`: it is one of the host's, not the link's own.
  // REQUIRES: all_sent(), text.size() <= kTextBytesMax.
  void push(std::string_view text, bool is_command, const LineEffort& effort = {});

  // How many of the host's commands are before that line. REQUIRES: oldest() <= sequence <= end().
  [[nodiscard]] std::int64_t commands_before(std::int64_t sequence) const;

  // A line that is kept. REQUIRES: oldest() <= sequence < end().
  [[nodiscard]] std::string_view text(std::int64_t sequence) const {
    const Line& line = at(sequence);
    return {line.text.data(), line.size};
  }

  // What a kept line costs the controller. REQUIRES: as text().
  [[nodiscard]] const LineEffort& effort(std::int64_t sequence) const {
    return at(sequence).effort;
  }

  // Whether a line in flight forbids that another is sent behind it.
  [[nodiscard]] bool lone_line_in_flight() const;

  // Adds a line of the link's own before the one that was never sent, if there is one.
  // REQUIRES: next_to_send() == sent_end(), end() - next_to_send() <= 1, as push().
  void push_ahead(std::string_view text);

  // The line at next_to_send(). REQUIRES: !all_sent().
  [[nodiscard]] std::string_view next_text() const;

  // Says that the line at next_to_send() has left as so many bytes. REQUIRES: !all_sent().
  void sent(std::size_t wire_bytes);

  // The oldest line in flight is done with; false when none is in flight.
  [[nodiscard]] bool acknowledge_one();

  // All before `sequence` are done with. REQUIRES: sequence <= next_to_send().
  void acknowledge_before(std::int64_t sequence);

  // Whether that line can be the next: not forgotten, and all before it were sent once.
  [[nodiscard]] bool can_restart(std::int64_t sequence) const {
    return sequence >= oldest_ && sequence <= sent_end_;
  }

  // REQUIRES: can_restart(sequence).
  void restart(std::int64_t sequence);

  // Drops all from next_to_send() on.
  void drop_unsent();

  // Drops what was never sent.
  void drop_never_sent() { end_ = sent_end_; }

  // Forgets what is acknowledged: it can no longer be asked for.
  void forget_acknowledged();

  // Line numbers (N) start again: the next line to be sent is N1.
  void restart_numbers() { numbering_base_ = next_to_send_ - 1; }
  [[nodiscard]] std::int64_t number_of(std::int64_t sequence) const {
    return sequence - numbering_base_;
  }
  [[nodiscard]] std::int64_t sequence_of(std::int64_t number) const {
    return number + numbering_base_;
  }

  // One behind the last line that was ever sent.
  [[nodiscard]] std::int64_t sent_end() const { return sent_end_; }

 private:
  struct Line {
    TextBuffer text{};
    std::uint8_t size = 0;
    std::uint8_t wire_bytes = 0;
    std::int64_t commands = 0;  // up to and with this line
    LineEffort effort;
  };

  [[nodiscard]] Line& at(std::int64_t sequence) {
    return lines_[static_cast<std::size_t>(sequence) % lines_.size()];
  }
  [[nodiscard]] const Line& at(std::int64_t sequence) const {
    return lines_[static_cast<std::size_t>(sequence) % lines_.size()];
  }

  std::int64_t oldest_ = 0;
  std::int64_t acknowledged_ = 0;
  std::int64_t next_to_send_ = 0;
  std::int64_t sent_end_ = 0;
  std::int64_t end_ = 0;
  std::int64_t numbering_base_ = -1;  // the first line is N1
  std::size_t bytes_in_flight_ = 0;
  std::int64_t commands_forgotten_ = 0;  // before oldest_
  std::array<Line, kHistoryLinesMax> lines_{};
};

}  // namespace firmware_link
