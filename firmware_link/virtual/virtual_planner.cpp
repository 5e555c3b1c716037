#include "firmware_link/virtual/virtual_planner.h"

#include <algorithm>
#include <cmath>

#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

double seconds_of(double length, double entry, double nominal, double exit, double acceleration) {
  // Too short to change speed that much: the mean of both ends.
  if (std::abs(entry * entry - exit * exit) >= 2 * acceleration * length) {
    return 2 * length / std::max(entry + exit, 1e-6);
  }
  const double reachable = std::sqrt((2 * acceleration * length + entry * entry + exit * exit) / 2);
  const double peak = std::min(nominal, reachable);
  const double ramps = (2 * peak * peak - entry * entry - exit * exit) / (2 * acceleration);
  return (2 * peak - entry - exit) / acceleration + std::max(0.0, length - ramps) / peak;
}

double cosine(const PlannerMove& a, const PlannerMove& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.direction.size(); ++i) sum += a.direction[i] * b.direction[i];
  return sum;
}

}  // namespace

void VirtualPlanner::push(const PlannerMove& move, Instant now, bool pause_was_asked) {
  LINK_CHECK(!full());
  LINK_CHECK(move.speed_mm_s > 0 && move.acceleration_mm_s2 > 0 && move.length_mm >= 0);
  double entry = 0;
  if (!blocks_.empty()) {
    const PlannerMove& before = blocks_.back().move;
    entry = std::max(0.0, cosine(before, move)) * std::min(before.speed_mm_s, move.speed_mm_s);
  } else if (moved_before_ && !pause_was_asked && now > running_until_) {
    ++underruns_;
  }
  blocks_.push({move, entry});
  count_max_ = std::max(count_max_, blocks_.size());
  moved_before_ = true;
  if (blocks_.size() == 1) start(now);
  // The block that runs needn't stop at its end any more.
  if (blocks_.size() == 2)
    running_until_ = std::max(now + Duration(1), end_of_first(running_since_));
}

void VirtualPlanner::start(Instant when) {
  running_since_ = when;
  running_until_ = end_of_first(when);
}

Instant VirtualPlanner::end_of_first(Instant start) {
  const Block& block = blocks_.front();
  const double exit = blocks_.size() > 1 ? blocks_[1].entry_speed_mm_s : 0;
  const double seconds = seconds_of(block.move.length_mm, block.entry_speed_mm_s,
                                    block.move.speed_mm_s, exit, block.move.acceleration_mm_s2);
  return start + Duration(std::max<std::int64_t>(1, std::llround(seconds * 1e6)));
}

void VirtualPlanner::advance(Instant now) {
  while (!blocks_.empty() && running_until_ <= now) {
    if (blocks_.size() < kPlannerBlocks / 2) low_ += running_until_ - running_since_;
    const std::int64_t ended = blocks_.pop().move.last_of;
    if (!blocks_.empty()) start(running_until_);
    if (ended >= 0 && moved) moved(ended);
  }
}

std::optional<Instant> VirtualPlanner::next_event() const {
  if (blocks_.empty()) return std::nullopt;
  return running_until_;
}

}  // namespace firmware_link
