#include "core/motions/motion_clock.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/check.h"
#include "core/trigonometry.h"  // hypotenuse

namespace core {
namespace {

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

}  // namespace

MotionClock::MotionClock(const MotionModel& model) : model_(model) {
  RIND_CHECK(model.acceleration_mm_s2 > 0 && model.filament_acceleration_mm_s2 > 0);
  RIND_CHECK(model.junction_deviation_mm >= 0);
}

void MotionClock::add(const Motion& motion) {
  std::visit(
      [this](const auto& m) {
        using M = std::decay_t<decltype(m)>;
        if constexpr (std::is_same_v<M, Extrude>) {
          const double z_mm = m.z ? m.z->mm() : z_mm_;
          add_line(m.to.x / kUnitsPerMm, m.to.y / kUnitsPerMm, z_mm, m.speed_mm_s);
        } else if constexpr (std::is_same_v<M, Travel> || std::is_same_v<M, Wipe>) {
          add_line(m.to.x / kUnitsPerMm, m.to.y / kUnitsPerMm, z_mm_, m.speed_mm_s);
        } else if constexpr (std::is_same_v<M, ExtrudeArc>) {
          add_arc(m);
        } else if constexpr (std::is_same_v<M, Lift>) {
          add_line(x_mm_, y_mm_, m.to.mm(), m.speed_mm_s);
        } else if constexpr (std::is_same_v<M, MoveFilament>) {
          add_filament(m.filament_mm, m.speed_mm_s);
        } else if constexpr (std::is_same_v<M, SetAcceleration>) {
          RIND_CHECK(m.mm_s2 > 0);
          model_.acceleration_mm_s2 = m.mm_s2;
        }
      },
      motion);
}

void MotionClock::add_line(double x_mm, double y_mm, double z_mm, double speed_mm_s) {
  const double dx = x_mm - x_mm_, dy = y_mm - y_mm_, dz = z_mm - z_mm_;
  const double length = hypotenuse(dx, dy, dz);
  if (length <= 0) return;
  x_mm_ = x_mm;
  y_mm_ = y_mm;
  z_mm_ = z_mm;
  push({.length_mm = length,
        .speed_mm_s = speed_mm_s,
        .acceleration_mm_s2 = model_.acceleration_mm_s2,
        .direction = {dx / length, dy / length, dz / length},
        .direction_end = {dx / length, dy / length, dz / length}});
}

void MotionClock::add_arc(const ExtrudeArc& arc) {
  if (arc.length_mm <= 0) return;
  const double cx = arc.centre.x / kUnitsPerMm, cy = arc.centre.y / kUnitsPerMm;
  // Tangents: the radius, a quarter turned.
  const double way = arc.clockwise ? -1 : 1;
  const auto tangent = [&](double x, double y) {
    const double radius = hypotenuse(x - cx, y - cy);
    RIND_CHECK(radius > 0);
    return Direction{-way * (y - cy) / radius, way * (x - cx) / radius, 0};
  };
  const double radius = hypotenuse(x_mm_ - cx, y_mm_ - cy);
  Move move;
  move.length_mm = arc.length_mm;
  move.speed_mm_s = std::min(arc.speed_mm_s, std::sqrt(model_.acceleration_mm_s2 * radius));
  move.acceleration_mm_s2 = model_.acceleration_mm_s2;
  move.direction = tangent(x_mm_, y_mm_);
  x_mm_ = arc.to.x / kUnitsPerMm;
  y_mm_ = arc.to.y / kUnitsPerMm;
  move.direction_end = tangent(x_mm_, y_mm_);
  push(move);
}

void MotionClock::add_filament(double filament_mm, double speed_mm_s) {
  if (filament_mm == 0) return;
  push({.length_mm = std::abs(filament_mm),
        .speed_mm_s = speed_mm_s,
        .acceleration_mm_s2 = model_.filament_acceleration_mm_s2,
        .direction = {},
        .direction_end = {}});
}

void MotionClock::push(const Move& move) {
  RIND_CHECK(move.speed_mm_s > 0);
  if (moves_.full()) {
    const Move oldest = *moves_.pop();
    seconds_done_ += trapezoid_seconds(oldest.length_mm, oldest.entry_speed_mm_s, oldest.speed_mm_s,
                                       moves_[0].entry_speed_mm_s, oldest.acceleration_mm_s2);
    // The move that now comes first has started: its entry speed is fixed.
    moves_[0].entry_speed_max_mm_s = moves_[0].entry_speed_mm_s;
  }
  Move planned = move;
  planned.entry_speed_max_mm_s =
      moves_.empty() ? 0.0 : corner_speed(moves_[moves_.size() - 1], move);
  moves_.push(planned);
  plan();
}

// Backwards: no move enters faster than it can brake for the next. Forwards: none enters faster
// than the one before can reach. A new move changes only the last moves: the first that brakes as
// it did before ends the way back, and nothing before it changes.
void MotionClock::plan() {
  double exit = 0;
  std::size_t first = moves_.size();
  while (first > 1) {
    Move& move = moves_[first - 1];
    const double speed = std::min(move.entry_speed_max_mm_s,
                                  reachable_speed(exit, move.length_mm, move.acceleration_mm_s2));
    if (speed == move.braking_speed_mm_s) break;
    move.braking_speed_mm_s = speed;
    exit = speed;
    --first;
  }
  for (std::size_t i = first; i < moves_.size(); ++i) {
    const Move& before = moves_[i - 1];
    moves_[i].entry_speed_mm_s = std::min(
        moves_[i].braking_speed_mm_s,
        reachable_speed(before.entry_speed_mm_s, before.length_mm, before.acceleration_mm_s2));
  }
}

double MotionClock::corner_speed(const Move& before, const Move& after) const {
  const Direction& u = before.direction_end;
  const Direction& v = after.direction;
  const bool filament = u.x == 0 && u.y == 0 && u.z == 0;
  if (filament || (v.x == 0 && v.y == 0 && v.z == 0)) return 0;
  const double bound = std::min(before.speed_mm_s, after.speed_mm_s);
  const double cosine = -(u.x * v.x + u.y * v.y + u.z * v.z);
  const double half_sine = std::sqrt(std::max(0.0, (1 - cosine) / 2));
  if (half_sine >= 1) return bound;
  const double squared = std::min(before.acceleration_mm_s2, after.acceleration_mm_s2) *
                         model_.junction_deviation_mm * half_sine / (1 - half_sine);
  return std::min(bound, std::sqrt(squared));
}

double MotionClock::seconds() const {
  double seconds = seconds_done_;
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    const Move& move = moves_[i];
    const double exit = i + 1 < moves_.size() ? moves_[i + 1].entry_speed_mm_s : 0.0;
    seconds += trapezoid_seconds(move.length_mm, move.entry_speed_mm_s, move.speed_mm_s, exit,
                                 move.acceleration_mm_s2);
  }
  return seconds;
}

}  // namespace core
