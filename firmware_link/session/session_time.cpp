// How long things may take: a host that stood still, a stop behind a command that takes long.
#include <algorithm>
#include <chrono>
#include <string>

#include "firmware_link/session/session.h"

namespace firmware_link {
namespace {

// A stop that waits says so after this.
constexpr Duration kQuietWait = std::chrono::seconds(2);

}  // namespace

void Session::bridge_gap(Instant now) {
  const Duration gap = signs_.turn(now);
  if (gap.count() == 0) return;
  stop_began_ = std::min(now, stop_began_ + gap);
  greeting_.bridge(gap, now);
  readiness_.bridge(gap, now);
  shutdown_.bridge(gap, now);
  recovery_.bridge(gap, now);
  silence_.bridge(gap, now);
  packing_.bridge(gap, now);
}

// What is in flight as a stop begins may take long by nature, whatever was lost of its answers: a
// G28 that probes, in silence.
void Session::note_stop_behind(Instant now) {
  stop_told_ = false;
  stop_behind_.reset();
  if (!window_.lone_line_in_flight()) return;
  // A question may stand behind it.
  std::int64_t at = window_.acknowledged();
  while (at + 1 < window_.next_to_send() && !wait_of(window_.text(at), rules().macros).is_long()) {
    ++at;
  }
  const std::string_view text = window_.text(at);
  stop_behind_ = std::string(text.substr(0, text.find(' ')));
  stop_began_ = now;
}

void Session::tick_stop(Instant now) {
  if (stop_behind_ && end_of_commands_ && window_.acknowledged() > *end_of_commands_) {
    stop_behind_.reset();
    stop_began_ = now;
  }
  // What has been planned moves first.
  const Instant began = std::max(stop_began_, std::min(planner_.end(), now));
  const bool waits = stop_behind_ || silence_.works();
  if (waits && !stop_told_ && now - stop_began_ > kQuietWait) {
    stop_told_ = true;
    events_.push(SessionEvent::Kind::kStopWaits, stop_behind_.value_or(""));
  }
  const Duration limit = waits ? options_.long_stop_limit : options_.stop_limit;
  if (now - began <= limit) return;
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - began).count();
  fault(FaultKind::kStop,
        "the controller did not acknowledge the stop within " + std::to_string(seconds) + " s",
        true);
}

}  // namespace firmware_link
