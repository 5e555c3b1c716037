#include "host/printing/safe_moves.h"

#include <algorithm>

#include "core/motions/park_height.h"  // park_height
#include "core/motions/park_place.h"   // park_place
#include "host/pipeline/wire_units.h"

namespace host {

using firmware_link::Command;
using firmware_link::Heater;
using firmware_link::Move;

std::int64_t retraction_10nm(const core::Settings& settings) {
  return filament_10nm(settings.retraction_mm);
}

std::int64_t lifted_um(std::int64_t z_um, const core::Settings& settings) {
  const auto from = core::Length::from_units(z_um * kUnitsPerUm);
  return core::park_height(from, settings).units() / kUnitsPerUm;
}

std::optional<std::int64_t> lifted_from_um(const MachineState& here) {
  if (!here.z_um || here.shifted) return here.z_um;
  return std::max(*here.z_um, here.highest_laid_um);
}

std::vector<Command> lift_off(std::int64_t draw_back_10nm, std::optional<std::int64_t> z_um,
                              const core::Settings& settings) {
  std::vector<Command> commands;
  if (draw_back_10nm > 0) {
    commands.push_back(filament_move(-draw_back_10nm, settings.retraction_speed_mm_s));
  }
  if (z_um) commands.push_back(lift_move(lifted_um(*z_um, settings), settings.lift_speed_mm_s));
  return commands;
}

Command park_move(const core::Settings& settings) {
  const core::Point at = core::park_place(settings);
  const std::int64_t x = at.x + settings.bed_origin_x.units();
  const std::int64_t y = at.y + settings.bed_origin_y.units();
  return travel_move(um_of(x), um_of(y), settings.travel_speed_mm_s);
}

std::vector<Command> heaters_off() {
  return {firmware_link::SetTemperature{Heater::kNozzle, 0, false},
          firmware_link::SetTemperature{Heater::kBed, 0, false}, firmware_link::SetFan{0}};
}

std::vector<Command> acceleration_given_back(const MachineState& here,
                                             const core::Settings& settings) {
  if (here.acceleration_mm_s2 == 0 || settings.default_acceleration_mm_s2 == 0) return {};
  const std::int32_t own_mm_s2 = acceleration_mm_s2(settings.default_acceleration_mm_s2);
  if (here.acceleration_mm_s2 == own_mm_s2) return {};
  return {firmware_link::SetAcceleration{here.flavor, own_mm_s2}};
}

std::vector<Command> percents_given_back(const MachineState& here) {
  std::vector<Command> commands;
  if (here.feed_percent != 100) commands.push_back(command_of("M220 S100"));
  if (here.flow_percent != 100) commands.push_back(command_of("M221 S100"));
  return commands;
}

Command filament_move(std::int64_t by_10nm, double speed_mm_s) {
  Move move;
  move.extruding = true;
  move.e_10nm = by_10nm;
  move.f_mm_min = feed_mm_min(speed_mm_s);
  return move;
}

Command travel_move(std::int64_t x_um, std::int64_t y_um, double speed_mm_s) {
  Move move;
  move.x_um = x_um;
  move.y_um = y_um;
  move.f_mm_min = feed_mm_min(speed_mm_s);
  return move;
}

Command lift_move(std::int64_t z_um, double speed_mm_s) {
  Move move;
  move.z_um = z_um;
  move.f_mm_min = feed_mm_min(speed_mm_s);
  return move;
}

}  // namespace host
