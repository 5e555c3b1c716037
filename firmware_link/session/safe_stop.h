// A stop: the safe sequence (lift, heaters off), where it goes in the order of lines, and how long
// it may take.
//
//     stop ──lines in flight are answered──> its start is known ──sent, acknowledged──> stopped
//       └──── behind a command that takes long: its own limit, and the host is told
//
// After a fault nobody waits: it is put out as plain lines, and the temperatures that are told
// behind it show whether it was obeyed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "firmware_link/session/output_buffer.h"  // OutputBuffer
#include "firmware_link/session/session_types.h"  // kSafeSequenceMax, SessionOptions
#include "firmware_link/wire/command.h"           // Command
#include "firmware_link/wire/instant.h"           // Instant
#include "firmware_link/wire/line_codec.h"        // TextBuffer
#include "firmware_link/wire/reply.h"             // Temperatures

namespace firmware_link {

class SafeStop {
 public:
  explicit SafeStop(Instant now) : since_(now) {}

  // REQUIRES: at most kSafeSequenceMax commands.
  void set_sequence(std::span<const Command> commands);

  // The stop starts. `behind`: the command at hand that may take long by nature, whatever was lost
  // of its answers.
  void start(std::optional<std::string> behind, Instant now);

  // Lines before `sequence` are the print's; those of the safe sequence follow.
  void starts_at(std::int64_t sequence) { start_ = sequence; }
  [[nodiscard]] bool has_start() const { return start_.has_value(); }

  // The commands one by one. REQUIRES: !all_taken().
  [[nodiscard]] bool all_taken() const { return next_ == count_; }
  [[nodiscard]] std::string_view take();

  // Puts all of it as plain lines, as far as a window holds them, and an M105 behind them.
  void put_plain(OutputBuffer& output) const;

  // --- waiting ---

  [[nodiscard]] const std::optional<std::string>& behind() const { return behind_; }
  // What it waited for is over when the first safe line has been acknowledged.
  void acknowledged(std::int64_t before, Instant now);

  // True once, when it is worth telling that the stop waits. `works`: the controller says so.
  [[nodiscard]] bool tells_wait(bool works, Instant now);
  // How long it has taken, when that is too long. `planner_end`: what has been planned moves first.
  [[nodiscard]] std::optional<Duration> overdue(const SessionOptions& options, bool works,
                                                Instant planner_end, Instant now) const;

  // --- after a fault ---

  // Listens for temperatures from now on, and for nothing else.
  void listen() { listens_ = true; }
  [[nodiscard]] bool listens() const { return listens_; }
  void told(const Temperatures& temperatures);
  // The controller has told that its heaters are to be off.
  [[nodiscard]] bool confirmed() const { return confirmed_; }

  // The host stood still for so long.
  void bridge(Duration gap, Instant now) { since_ = std::min(now, since_ + gap); }

 private:
  [[nodiscard]] std::string_view text(std::size_t index) const {
    return {texts_[index].data(), sizes_[index]};
  }

  std::array<TextBuffer, kSafeSequenceMax> texts_{};
  std::array<std::uint8_t, kSafeSequenceMax> sizes_{};
  std::size_t count_ = 0;
  std::size_t next_ = 0;
  std::optional<std::int64_t> start_;
  Instant since_;
  std::optional<std::string> behind_;
  bool told_wait_ = false;
  bool listens_ = false;
  bool confirmed_ = false;
};

}  // namespace firmware_link
