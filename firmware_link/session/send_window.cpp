#include "firmware_link/session/send_window.h"

#include <algorithm>

#include "firmware_link/wire/check.h"

namespace firmware_link {

static_assert(kLineBytesMax + 1 <= UINT8_MAX, "Line::wire_bytes must hold the longest line");

void SendWindow::push(std::string_view text, bool is_command, const LineEffort& effort) {
  LINK_CHECK(all_sent());
  LINK_CHECK(!text.empty() && text.size() <= kTextBytesMax);
  const std::int64_t commands = commands_before(end_);
  if (end_ - oldest_ == static_cast<std::int64_t>(kHistoryLinesMax)) {
    commands_forgotten_ = at(oldest_++).commands;
  }
  // A window is far smaller than the history, so only acknowledged lines are ever forgotten.
  LINK_CHECK(oldest_ <= acknowledged_);
  Line& line = at(end_++);
  line.commands = commands + (is_command ? 1 : 0);
  std::copy(text.begin(), text.end(), line.text.begin());
  line.size = static_cast<std::uint8_t>(text.size());
  line.wire_bytes = 0;
  line.effort = effort;
}

std::int64_t SendWindow::commands_before(std::int64_t sequence) const {
  LINK_CHECK(sequence >= oldest_ && sequence <= end_);
  return sequence == oldest_ ? commands_forgotten_ : at(sequence - 1).commands;
}

std::string_view SendWindow::next_text() const {
  LINK_CHECK(!all_sent());
  return text(next_to_send_);
}

void SendWindow::push_ahead(std::string_view text) {
  LINK_CHECK(next_to_send_ == sent_end_ && end_ - next_to_send_ <= 1);
  if (all_sent()) {
    push(text, false);
    return;
  }
  const Line held = at(next_to_send_);
  const bool is_command = held.commands > commands_before(next_to_send_);
  --end_;
  push(text, false);
  // Not by push(), which wants all_sent().
  const std::int64_t commands = at(end_ - 1).commands;
  if (end_ - oldest_ == static_cast<std::int64_t>(kHistoryLinesMax)) {
    commands_forgotten_ = at(oldest_++).commands;
  }
  LINK_CHECK(oldest_ <= acknowledged_);
  Line& line = at(end_++);
  line = held;
  line.commands = commands + (is_command ? 1 : 0);
}

void SendWindow::sent(std::size_t wire_bytes) {
  LINK_CHECK(!all_sent());
  LINK_CHECK(wire_bytes > 0 && wire_bytes <= kLineBytesMax + 1);
  at(next_to_send_++).wire_bytes = static_cast<std::uint8_t>(wire_bytes);
  sent_end_ = std::max(sent_end_, next_to_send_);
  bytes_in_flight_ += wire_bytes;
}

bool SendWindow::lone_line_in_flight() const {
  for (std::int64_t i = acknowledged_; i < next_to_send_; ++i) {
    if (at(i).effort.goes_alone) return true;
  }
  return false;
}

bool SendWindow::acknowledge_one() {
  if (acknowledged_ == next_to_send_) return false;
  bytes_in_flight_ -= at(acknowledged_++).wire_bytes;
  return true;
}

void SendWindow::acknowledge_before(std::int64_t sequence) {
  LINK_CHECK(sequence <= next_to_send_);
  while (acknowledged_ < sequence) LINK_CHECK(acknowledge_one());
}

void SendWindow::restart(std::int64_t sequence) {
  LINK_CHECK(can_restart(sequence));
  acknowledged_ = std::min(acknowledged_, sequence);
  next_to_send_ = sequence;
  bytes_in_flight_ = 0;
  for (std::int64_t i = acknowledged_; i < next_to_send_; ++i) {
    bytes_in_flight_ += at(i).wire_bytes;
  }
}

void SendWindow::drop_unsent() {
  end_ = next_to_send_;
  sent_end_ = next_to_send_;
}

void SendWindow::forget_acknowledged() {
  commands_forgotten_ = commands_before(acknowledged_);
  oldest_ = acknowledged_;
}

}  // namespace firmware_link
