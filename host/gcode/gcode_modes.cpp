#include "host/gcode/gcode_modes.h"

#include <algorithm>

namespace host {

using firmware_link::Effect;
using firmware_link::PlaceAfter;

std::int64_t drawn_back_after(const firmware_link::Move& move, std::int64_t before_10nm) {
  const bool filament_alone = move.e_10nm && !move.x_um && !move.y_um;
  // A wipe draws filament back while the nozzle moves.
  if (!filament_alone && move.e_10nm.value_or(0) >= 0) return before_10nm;
  return std::max<std::int64_t>(0, before_10nm - *move.e_10nm);
}

std::int64_t highest_laid_after(const firmware_link::Move& move,
                                const std::optional<std::int64_t>& z_um, std::int64_t before_um) {
  return z_um && lays_road(move) ? std::max(before_um, *z_um) : before_um;
}

void GcodeModes::apply(const firmware_link::ReadyLine& line) {
  const firmware_link::Move& move = line.move;
  if (move.x_um) x_um = move.x_um;
  if (move.y_um) y_um = move.y_um;
  if (move.z_um) z_um = move.z_um;
  if (move.f_mm_min) f_mm_min = move.f_mm_min;
  e_count_10nm += move.e_10nm.value_or(0);
  drawn_back_10nm = drawn_back_after(move, drawn_back_10nm);
  highest_laid_um = highest_laid_after(move, z_um, highest_laid_um);
  road_laid = road_laid || lays_road(move);
  if (line.shifted) shifted = *line.shifted;
  if (line.place == PlaceAfter::kAxesLost) {
    if ((line.lost_axes & 1) != 0) x_um.reset();
    if ((line.lost_axes & 2) != 0) y_um.reset();
    if ((line.lost_axes & 4) != 0) z_um.reset();
  }
  const auto value = static_cast<std::int32_t>(line.effect.value);
  switch (line.effect.kind) {
    case Effect::Kind::kNone:
      return;
    case Effect::Kind::kModes:
      modes = value;
      return;
    case Effect::Kind::kFilamentCount:
      e_count_10nm = line.effect.value;
      return;
    case Effect::Kind::kNozzle:
      nozzle_tenths = value;
      return;
    case Effect::Kind::kBed:
      bed_tenths = value;
      return;
    case Effect::Kind::kFan:
      fan = static_cast<std::uint8_t>(value);
      return;
    case Effect::Kind::kFeedPercent:
      feed_percent = value;
      return;
    case Effect::Kind::kFlowPercent:
      flow_percent = value;
      return;
    case Effect::Kind::kTool:
      tool = value;
      return;
  }
}

}  // namespace host
