#include "firmware_link/session/position_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

// M114 tells two decimals, rounded; controllers count in 32-bit floats.
constexpr double kToldHalf_mm = 0.0051;
constexpr double kFloatShare = 6e-8;

double mm_of_um(std::int64_t um) { return static_cast<double>(um) * 1e-3; }

double axis_tolerance_mm(double mm) { return kToldHalf_mm + std::abs(mm) * kFloatShare * 4; }

// Each move rounds the count once; roundings of either sign add up as their root does.
double filament_tolerance_mm(const PositionWatch::Expected& then) {
  const double count_mm = std::abs(static_cast<double>(then.e_10nm.value_or(0)) * 1e-5);
  return kToldHalf_mm +
         4 * std::sqrt(static_cast<double>(then.moves)) * std::max(1.0, count_mm) * kFloatShare;
}

std::string axes_text(const std::array<std::optional<double>, 3>& axes_mm) {
  constexpr char kNames[] = {'X', 'Y', 'Z'};
  std::string text;
  for (std::size_t axis = 0; axis < axes_mm.size(); ++axis) {
    if (!axes_mm[axis].has_value()) continue;
    const double mm = axes_mm[axis].value_or(0);
    char part[48];
    std::snprintf(part, sizeof part, "%s%c%.2f", text.empty() ? "" : " ", kNames[axis], mm);
    text += part;
  }
  return text;
}

std::array<std::optional<double>, 3> axes_of(const Position& told) {
  return {told.x_mm, told.y_mm, told.z_mm};
}

}  // namespace

void PositionWatch::gave(const Move& move) {
  if (move.x_um) expected_.axes_um[0] = move.x_um;
  if (move.y_um) expected_.axes_um[1] = move.y_um;
  if (move.z_um) expected_.axes_um[2] = move.z_um;
  if (move.f_mm_min) feed_mm_min_ = *move.f_mm_min;
  if (!move.e_10nm) return;
  if (expected_.e_10nm) *expected_.e_10nm += *move.e_10nm;
  ++expected_.moves;
}

void PositionWatch::gave_ready(const ReadyLine& line, bool counts) {
  if (line.place == PlaceAfter::kAsBefore || line.place == PlaceAfter::kAxesLost) gave_unknown();
  const bool set = line.effect.kind == Effect::Kind::kFilamentCount;
  if (set && line.effect.value == 0 && counts) return gave_filament_reset();
  if (set || line.place == PlaceAfter::kFilament) expected_.e_10nm.reset();
}

void PositionWatch::gave_filament_reset() {
  expected_.e_10nm = 0;
  expected_.moves = 0;
}

// Negative when it is not known.
double PositionWatch::straight_um(const Move& move) const {
  const std::optional<std::int64_t> to[] = {move.x_um, move.y_um, move.z_um};
  double squares = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!to[axis]) continue;
    if (!expected_.axes_um[axis]) return -1;
    const double way = static_cast<double>(*to[axis] - *expected_.axes_um[axis]);
    squares += way * way;
  }
  return std::sqrt(squares);
}

Duration PositionWatch::nominal_time(const Move& move) const {
  const std::int64_t feed = move.f_mm_min.value_or(feed_mm_min_);
  if (feed <= 0) return Duration(0);
  double way_um = move.arc ? static_cast<double>(move.arc->length_um) : straight_um(move);
  if (way_um < 0) return Duration(0);
  if (way_um == 0) way_um = std::abs(static_cast<double>(move.e_10nm.value_or(0))) / 100;
  // µm over mm/min, in µs.
  const double time_us = way_um * 60'000 / static_cast<double>(feed);
  return Duration(std::llround(std::min(time_us, 3.6e9)));
}

PositionWatch::Verdict PositionWatch::compare(const Expected& then, const Position& told) {
  const auto axes_mm = axes_of(told);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!then.axes_um[axis] || !axes_mm[axis]) continue;
    const double expected_mm = mm_of_um(*then.axes_um[axis]);
    if (std::abs(*axes_mm[axis] - expected_mm) > axis_tolerance_mm(expected_mm)) {
      return Verdict::kPositionDiffers;
    }
  }
  if (!then.e_10nm || !told.e_mm) return Verdict::kAgrees;
  const double excess_mm = *told.e_mm - static_cast<double>(*then.e_10nm) * 1e-5;
  return std::abs(excess_mm) > filament_tolerance_mm(then) ? Verdict::kFilamentDiffers
                                                           : Verdict::kAgrees;
}

std::int64_t PositionWatch::filament_excess_10nm(const Expected& then, const Position& told) {
  LINK_CHECK(then.e_10nm && told.e_mm);
  // Any number may come.
  const double told_10nm = std::clamp(*told.e_mm * 1e5, -1e15, 1e15);
  return std::llround(told_10nm) - *then.e_10nm;
}

std::string PositionWatch::text_of(const Expected& expected) {
  std::array<std::optional<double>, 3> axes_mm;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (expected.axes_um[axis]) axes_mm[axis] = mm_of_um(*expected.axes_um[axis]);
  }
  return axes_text(axes_mm);
}

std::string PositionWatch::text_of(const Position& position) {
  return axes_text(axes_of(position));
}

}  // namespace firmware_link
