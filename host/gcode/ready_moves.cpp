#include "host/gcode/ready_moves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace host {
namespace {

using firmware_link::Arc;
using firmware_link::Effect;
using firmware_link::Move;

constexpr std::int64_t kFixedPerUm = 100;
constexpr std::int64_t kFixedPerOne = 100'000;

// 25.4, as a fraction. What is so far away that it would not fit is no machine's place.
std::int64_t from_inches(std::int64_t fixed, const GcodeModes& modes) {
  if (!modes.has(Effect::kInches)) return fixed;
  return divided(std::clamp<std::int64_t>(fixed, -1'000'000'000'000, 1'000'000'000'000) * 127, 5);
}

// Where an axis goes; nothing: it is not named, or moves by so much from nobody knows where.
std::optional<std::int64_t> target(std::optional<std::int64_t> fixed,
                                   const std::optional<std::int64_t>& from,
                                   const GcodeModes& modes) {
  if (!fixed) return std::nullopt;
  const std::int64_t um = um_in(*fixed, modes);
  if (!modes.has(Effect::kRelativePlace)) return um;
  if (!from) return std::nullopt;
  return *from + um;
}

std::int32_t within_int(double value) {
  return static_cast<std::int32_t>(std::lround(std::clamp(value, -2e9, 2e9)));
}

// The way of an arc in the plane; nothing: from nobody knows where.
std::optional<Arc> arc_of(bool clockwise, const GcodeNumbers& numbers, const GcodeModes& modes,
                          const Move& move) {
  if (!modes.x_um || !modes.y_um) return std::nullopt;
  const auto from_x = static_cast<double>(*modes.x_um);
  const auto from_y = static_cast<double>(*modes.y_um);
  const auto to_x = static_cast<double>(move.x_um.value_or(*modes.x_um));
  const auto to_y = static_cast<double>(move.y_um.value_or(*modes.y_um));
  Arc arc;
  arc.clockwise = clockwise;
  double length = std::hypot(to_x - from_x, to_y - from_y);
  if (numbers.has('I') || numbers.has('J')) {
    const auto i = static_cast<double>(um_in(numbers.fixed('I').value_or(0), modes));
    const auto j = static_cast<double>(um_in(numbers.fixed('J').value_or(0), modes));
    const double begin = std::atan2(-j, -i);
    const double end = std::atan2(to_y - from_y - j, to_x - from_x - i);
    double turn = clockwise ? begin - end : end - begin;
    // Back to its start: a whole circle.
    if (turn <= 1e-9) turn += 2 * std::numbers::pi;
    length = turn * std::hypot(i, j);
    arc.i_um = within_int(i);
    arc.j_um = within_int(j);
  } else if (const auto radius = numbers.fixed('R')) {
    const auto r = std::abs(static_cast<double>(um_in(*radius, modes)));
    if (2 * r >= length && r > 0) length = 2 * r * std::asin(length / (2 * r));
  }
  arc.length_um = within_int(length);
  return arc;
}

}  // namespace

std::int64_t um_in(std::int64_t fixed, const GcodeModes& modes) {
  return divided(from_inches(fixed, modes), kFixedPerUm);
}

std::int64_t filament_10nm_in(std::int64_t fixed, const GcodeModes& modes) {
  return from_inches(fixed, modes);
}

void read_move(int code, const GcodeNumbers& numbers, const GcodeModes& modes,
               firmware_link::ReadyLine& line) {
  Move& move = line.move;
  move.extruding = code != 0;
  move.x_um = target(numbers.fixed('X'), modes.x_um, modes);
  move.y_um = target(numbers.fixed('Y'), modes.y_um, modes);
  move.z_um = target(numbers.fixed('Z'), modes.z_um, modes);
  if (const auto filament = numbers.fixed('E')) {
    const std::int64_t told = filament_10nm_in(*filament, modes);
    move.e_10nm = modes.has(Effect::kRelativeFilament) ? told : told - modes.e_count_10nm;
  }
  if (const auto feed = numbers.fixed('F'); feed && *feed > 0) {
    move.f_mm_min = std::max<std::int64_t>(1, divided(from_inches(*feed, modes), kFixedPerOne));
  }
  if (code >= 2) move.arc = arc_of(code == 2, numbers, modes, move);
  // What a controller tells of its place is in inches then, too.
  if (modes.has(Effect::kInches)) line.place = firmware_link::PlaceAfter::kAsBefore;
}

}  // namespace host
