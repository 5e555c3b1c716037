#include "core/motions/motion_clock.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/check.h"
#include "core/trigonometry.h"  // hypotenuse

namespace core {
namespace {

constexpr std::size_t kFilament = 3;

// Times are summed up as whole numbers of 15 ps: so their sum does not depend on how the moves were
// grouped. 63 bits hold four years.
constexpr double kTicksPerSecond = static_cast<double>(std::int64_t{1} << 36);

std::int64_t ticks(double seconds) { return std::llround(seconds * kTicksPerSecond); }

// Time of one trapezoid (or triangle, where the wanted speed is not reached).
double trapezoid_seconds(double length, double entry, double speed, double exit, double a) {
  const double peak_squared = (2 * a * length + entry * entry + exit * exit) / 2;
  const double peak = std::min(speed, std::sqrt(peak_squared));
  const double ramps = (2 * peak * peak - entry * entry - exit * exit) / (2 * a);
  const double cruise = std::max(0.0, length - ramps);
  return std::max(0.0, peak - entry) / a + std::max(0.0, peak - exit) / a + cruise / peak;
}

// The fastest speed from which, or to which, `speed` is reached over `length`.
double reachable_speed(double speed, double length, double a) {
  return std::sqrt(speed * speed + 2 * a * length);
}

// By axis, 0 where it has no limit.
AxisLimits inverse_of(const AxisLimits& limits) {
  AxisLimits inverse{};
  for (std::size_t axis = 0; axis < kMotionAxes; ++axis) {
    if (limits[axis] > 0) inverse[axis] = 1 / limits[axis];
  }
  return inverse;
}

// The most along a way that takes, of one axis, this share of its limit.
double most_of(double share) {
  return share > 0 ? 1 / share : std::numeric_limits<double>::infinity();
}

bool filament_alone(const AxisLimits& direction) {
  return direction[0] == 0 && direction[1] == 0 && direction[2] == 0;
}

void check(const MotionModel& model) {
  RIND_CHECK(model.acceleration_mm_s2 > 0 && model.filament_acceleration_mm_s2 > 0);
  RIND_CHECK(model.junction_deviation_mm >= 0);
}

}  // namespace

MotionClock::MotionClock(const MotionModel& model) { set_model(model); }

void MotionClock::set_model(const MotionModel& model) {
  check(model);
  model_ = model;
  per_speed_ = inverse_of(model.speed_max_mm_s);
  per_acceleration_ = inverse_of(model.acceleration_max_mm_s2);
  per_jerk_ = inverse_of(model.jerk_mm_s);
}

void MotionClock::set_place(double x_mm, double y_mm, double z_mm) {
  x_mm_ = x_mm;
  y_mm_ = y_mm;
  z_mm_ = z_mm;
}

void MotionClock::rest(double seconds) {
  RIND_CHECK(seconds >= 0);
  ticks_done_ += ticks_planned() + ticks(seconds);
  while (moves_.size() > 0) (void)moves_.pop();
}

void MotionClock::add(const Move& move) {
  RIND_CHECK(move.speed_mm_s > 0);
  const double dx = move.x_mm - x_mm_, dy = move.y_mm - y_mm_, dz = move.z_mm - z_mm_;
  Block block;
  const bool round = move.arc && arc_directions(*move.arc, move, block);
  const double way = round ? move.arc->length_mm : hypotenuse(dx, dy, dz);
  block.length_mm = way > 0 ? way : std::abs(move.filament_mm);
  if (block.length_mm <= 0) return;
  if (!round && way > 0) {
    block.direction = {dx / way, dy / way, dz / way, 0};
    block.direction_end = block.direction;
  }
  block.direction[kFilament] = move.filament_mm / block.length_mm;
  block.direction_end[kFilament] = block.direction[kFilament];
  limit(move, round, block);
  if (round) {
    const double radius = hypotenuse(x_mm_ - move.arc->centre_x_mm, y_mm_ - move.arc->centre_y_mm);
    block.speed_mm_s = std::min(block.speed_mm_s, std::sqrt(block.acceleration_mm_s2 * radius));
  }
  set_place(move.x_mm, move.y_mm, move.z_mm);
  push(block);
}

// Tangents: the radius, a quarter turned. False where it is no arc: it has no radius or no length.
bool MotionClock::arc_directions(const Arc& arc, const Move& move, Block& block) const {
  if (arc.length_mm <= 0) return false;
  const double turn = arc.clockwise ? -1 : 1;
  const auto tangent = [&](double x, double y, AxisLimits& direction) {
    const double radius = hypotenuse(x - arc.centre_x_mm, y - arc.centre_y_mm);
    if (radius <= 0) return false;
    direction = {-turn * (y - arc.centre_y_mm) / radius, turn * (x - arc.centre_x_mm) / radius, 0,
                 0};
    return true;
  };
  return tangent(x_mm_, y_mm_, block.direction) &&
         tangent(move.x_mm, move.y_mm, block.direction_end);
}

// `round`: an arc, which has all directions of its plane.
void MotionClock::limit(const Move& move, bool round, Block& block) const {
  const bool alone = filament_alone(block.direction);
  double acceleration = model_.acceleration_mm_s2;
  if (alone) {
    acceleration = model_.filament_acceleration_mm_s2;
  } else if (move.filament_mm == 0 && model_.travel_acceleration_mm_s2 > 0) {
    acceleration = model_.travel_acceleration_mm_s2;
  }
  double speed_share = 0, acceleration_share = 0, jerk_share = 0;
  for (std::size_t axis = 0; axis < kMotionAxes; ++axis) {
    const double along = std::abs(block.direction[axis]);
    const double share = round && axis < 2 ? 1.0 : along;
    speed_share = std::max(speed_share, share * per_speed_[axis]);
    acceleration_share = std::max(acceleration_share, share * per_acceleration_[axis]);
    jerk_share = std::max(jerk_share, along * per_jerk_[axis]);
  }
  block.speed_mm_s = std::min(move.speed_mm_s, most_of(speed_share));
  block.acceleration_mm_s2 = std::min(acceleration, most_of(acceleration_share));
  block.start_speed_mm_s = model_.jerks() ? std::min(most_of(jerk_share), block.speed_mm_s) : 0;
}

void MotionClock::push(Block& block) {
  if (moves_.full()) {
    const Block& oldest = moves_[0];
    ticks_done_ +=
        ticks(trapezoid_seconds(oldest.length_mm, oldest.entry_speed_mm_s, oldest.speed_mm_s,
                                moves_[1].entry_speed_mm_s, oldest.acceleration_mm_s2));
    moves_.drop();
    // The move that now comes first has started: its entry speed is fixed.
    moves_[0].entry_speed_max_mm_s = moves_[0].entry_speed_mm_s;
  }
  block.entry_speed_max_mm_s =
      moves_.empty() ? block.start_speed_mm_s : corner_speed(moves_[moves_.size() - 1], block);
  if (moves_.empty()) block.entry_speed_mm_s = block.start_speed_mm_s;
  moves_.push(block);
  plan();
}

// Backwards: no move enters faster than it can brake for the next. Forwards: none enters faster
// than the one before can reach. A new move changes only the last moves: the first that brakes as
// it did before ends the way back, and nothing before it changes.
void MotionClock::plan() {
  double exit = moves_[moves_.size() - 1].start_speed_mm_s;
  std::size_t first = moves_.size();
  while (first > 1) {
    Block& move = moves_[first - 1];
    const double speed = std::min(move.entry_speed_max_mm_s,
                                  reachable_speed(exit, move.length_mm, move.acceleration_mm_s2));
    if (speed == move.braking_speed_mm_s) break;
    move.braking_speed_mm_s = speed;
    exit = speed;
    --first;
  }
  for (std::size_t i = first; i < moves_.size(); ++i) {
    const Block& before = moves_[i - 1];
    moves_[i].entry_speed_mm_s = std::min(
        moves_[i].braking_speed_mm_s,
        reachable_speed(before.entry_speed_mm_s, before.length_mm, before.acceleration_mm_s2));
  }
}

// The fastest at which no axis changes its speed by more than its jerk. An axis that turns back
// stops first: the larger of both its speeds counts.
double MotionClock::jerk_speed(const AxisLimits& before, const AxisLimits& after) const {
  double share = 0;
  for (std::size_t axis = 0; axis < kMotionAxes; ++axis) {
    const double u = before[axis], v = after[axis];
    const double change = u * v < 0 ? std::max(std::abs(u), std::abs(v)) : std::abs(u - v);
    share = std::max(share, change * per_jerk_[axis]);
  }
  return most_of(share);
}

double MotionClock::corner_speed(const Block& before, const Block& after) const {
  const AxisLimits& u = before.direction_end;
  const AxisLimits& v = after.direction;
  const double bound = std::min(before.speed_mm_s, after.speed_mm_s);
  if (model_.jerks()) return std::min(bound, jerk_speed(u, v));
  if (filament_alone(u) || filament_alone(v)) return 0;
  const double cosine = -(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
  const double half_sine = std::sqrt(std::max(0.0, (1 - cosine) / 2));
  if (half_sine >= 1) return bound;
  const double a = std::min(before.acceleration_mm_s2, after.acceleration_mm_s2);
  const double square = model_.square_corner_mm_s * model_.square_corner_mm_s;
  const double a_deviation =
      square > 0 ? square * (std::sqrt(2.0) - 1) : a * model_.junction_deviation_mm;
  return std::min(bound, std::sqrt(a_deviation * half_sine / (1 - half_sine)));
}

double MotionClock::exit_of(std::size_t block) const {
  if (block + 1 < moves_.size()) return moves_[block + 1].entry_speed_mm_s;
  return moves_[block].start_speed_mm_s;
}

std::int64_t MotionClock::ticks_planned() const {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    const Block& move = moves_[i];
    sum += ticks(trapezoid_seconds(move.length_mm, move.entry_speed_mm_s, move.speed_mm_s,
                                   exit_of(i), move.acceleration_mm_s2));
  }
  return sum;
}

double MotionClock::seconds() const {
  return static_cast<double>(ticks_done_ + ticks_planned()) / kTicksPerSecond;
}

bool MotionClock::goes_on_as(const MotionClock& from, bool any_height) const {
  if (x_mm_ != from.x_mm_ || y_mm_ != from.y_mm_ || !(model_ == from.model_)) return false;
  if (!any_height && z_mm_ != from.z_mm_) return false;
  if (moves_.size() != from.moves_.size()) return false;
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    if (!(moves_[i] == from.moves_[i])) return false;
  }
  return true;
}

void MotionClock::skip(const MotionClock& from, const MotionClock& to, bool any_height) {
  ticks_done_ += to.ticks_done_ - from.ticks_done_;
  moves_ = to.moves_;
  set_model(to.model_);
  set_place(to.x_mm_, to.y_mm_, any_height ? z_mm_ : to.z_mm_);
}

}  // namespace core
