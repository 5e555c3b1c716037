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

bool only_filament(const PlannerMove& move) {
  return move.direction[0] == 0 && move.direction[1] == 0 && move.direction[2] == 0;
}

// At which no axis jumps by more than its jerk, from `before` to `after`; a jump through rest is as
// large as the larger of both.
double jerk_speed(const VirtualAxes& jerk, const VirtualAxes& before, const VirtualAxes& after,
                  double speed) {
  for (std::size_t axis = 0; axis < jerk.size(); ++axis) {
    const bool turns = (before[axis] < 0) != (after[axis] < 0);
    const double jump = turns ? std::max(std::abs(before[axis]), std::abs(after[axis]))
                              : std::abs(after[axis] - before[axis]);
    if (jerk[axis] > 0 && speed * jump > jerk[axis]) speed = jerk[axis] / jump;
  }
  return speed;
}

double corner_speed(const PlannerMove& before, const PlannerMove& after) {
  const double speed = std::min(before.speed_mm_s, after.speed_mm_s);
  if (after.goes_on) return speed;
  const VirtualCorners& corners = after.corners;
  if (corners.jerk_mm_s[0] > 0) {
    return jerk_speed(corners.jerk_mm_s, before.direction, after.direction, speed);
  }
  if (only_filament(before) || only_filament(after)) return 0;
  double along = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    along += before.direction[axis] * after.direction[axis];
  }
  // Half of the turn: along = cos(turn).
  const double half_cosine = std::sqrt(std::clamp((1 + along) / 2, 0.0, 1.0));
  if (half_cosine >= 1) return speed;
  const double acceleration = std::min(before.acceleration_mm_s2, after.acceleration_mm_s2);
  const double square = std::pow(corners.square_corner_mm_s, 2);
  const double radius =
      square > 0 ? square * (std::sqrt(2.0) - 1) / acceleration : corners.junction_deviation_mm;
  return std::min(speed, std::sqrt(acceleration * radius * half_cosine / (1 - half_cosine)));
}

}  // namespace

void VirtualPlanner::push(const PlannerMove& move, Instant now, bool pause_was_asked) {
  LINK_CHECK(!full());
  LINK_CHECK(move.speed_mm_s > 0 && move.acceleration_mm_s2 > 0 && move.length_mm >= 0);
  Block block{move};
  if (move.corners.jerk_mm_s[0] > 0) {
    block.rest_speed_mm_s = jerk_speed(move.corners.jerk_mm_s, {}, move.direction, move.speed_mm_s);
  }
  double entry = block.rest_speed_mm_s;
  if (!blocks_.empty()) {
    entry = corner_speed(blocks_.back().move, move);
  } else if (moved_before_ && !pause_was_asked && now > running_until_) {
    ++underruns_;
  }
  block.entry_squared = block.entry_squared_max = entry * entry;
  blocks_.push(block);
  count_max_ = std::max(count_max_, blocks_.size());
  moved_before_ = true;
  if (blocks_.size() == 1) {
    start(now);
    return;
  }
  plan();
  // The block that runs may end faster now.
  running_until_ = std::max(now + Duration(1), end_of_first(running_since_));
}

// The first block's entry is past.
void VirtualPlanner::plan() {
  double exit = std::pow(blocks_.back().rest_speed_mm_s, 2);
  for (std::size_t i = blocks_.size() - 1; i > 0; --i) {
    Block& block = blocks_[i];
    const double gain = 2 * block.move.acceleration_mm_s2 * block.move.length_mm;
    block.entry_squared = std::min(block.entry_squared_max, exit + gain);
    exit = block.entry_squared;
  }
  for (std::size_t i = 1; i < blocks_.size(); ++i) {
    const Block& before = blocks_[i - 1];
    const double gain = 2 * before.move.acceleration_mm_s2 * before.move.length_mm;
    blocks_[i].entry_squared = std::min(blocks_[i].entry_squared, before.entry_squared + gain);
  }
}

void VirtualPlanner::start(Instant when) {
  running_since_ = when;
  running_until_ = end_of_first(when);
}

Instant VirtualPlanner::end_of_first(Instant start) {
  const Block& block = blocks_.front();
  const double exit =
      blocks_.size() > 1 ? std::sqrt(blocks_[1].entry_squared) : block.rest_speed_mm_s;
  const double seconds = seconds_of(block.move.length_mm, std::sqrt(block.entry_squared),
                                    block.move.speed_mm_s, exit, block.move.acceleration_mm_s2);
  return start + Duration(std::max<std::int64_t>(1, std::llround(seconds * 1e6)));
}

void VirtualPlanner::advance(Instant now) {
  while (!blocks_.empty() && running_until_ <= now) {
    busy_ += running_until_ - running_since_;
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
