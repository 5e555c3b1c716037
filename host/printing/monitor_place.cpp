// Where a controller that numbers nothing was found, and what follows for going on.
#include <algorithm>

#include "host/printing/monitor.h"
#include "host/printing/told_place.h"

namespace host {

// Fills the history up to that command of the print; false: geometry has not made it yet.
bool Monitor::history_reaches(std::int64_t command) {
  while (index_ < command) {
    if (peek() == nullptr) return queue_.drained() && !queue_.closed();
    advance();
  }
  return true;
}

// REQUIRES: what was sent is in the history, as far as there is any.
ResumePoint Monitor::point_of(const JournalRecord& left, bool same_boot) const {
  const std::optional<firmware_link::Position>& place = session_->found_place();
  if (session_->numbers_lines() || !place || left.accepted < history_.begin() ||
      left.accepted > history_.end()) {
    return resume_point(left, {session_->found_line(), session_->numbers_lines(), same_boot});
  }
  const std::int64_t last = std::max(left.accepted, std::min(commands_sent(left), history_.end()));
  return resume_point_at(left, {*place, session_->found_homed().value_or(false)}, last,
                         [this](std::int64_t command) { return history_.state_before(command); });
}

// Why a controller that has lost its position cannot be told its height; empty: it can, or need
// not be told.
std::string Monitor::height_unknown(const ResumePoint& point) const {
  if (point.lives) return {};
  return std::string(session_->dialect().no_height_command(session_->capabilities()));
}

LinkOutcome Monitor::unplaced() const {
  LinkOutcome result = outcome(LinkEnd::kFaulted);
  result.reason = unplaced_;
  result.measures = "nothing was heated or moved";
  return result;
}

}  // namespace host
