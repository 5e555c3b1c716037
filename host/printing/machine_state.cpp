#include "host/printing/machine_state.h"

#include <algorithm>
#include <variant>

#include "host/pipeline/wire_units.h"

namespace host {
namespace {

using firmware_link::Move;

void apply_move(const Move& move, MachineState& state) {
  const bool filament_alone = move.e_10nm && !move.x_um && !move.y_um;
  if (move.x_um) state.x_um = move.x_um;
  if (move.y_um) state.y_um = move.y_um;
  if (move.z_um) state.z_um = move.z_um;
  if (move.f_mm_min) state.f_mm_min = move.f_mm_min;
  // A wipe draws filament back while the nozzle moves.
  if (filament_alone || move.e_10nm.value_or(0) < 0) {
    state.drawn_back_10nm = std::max<std::int64_t>(0, state.drawn_back_10nm - *move.e_10nm);
  }
}

}  // namespace

void MachineState::apply(const firmware_link::Command& command) {
  if (const auto* move = std::get_if<Move>(&command)) {
    apply_move(*move, *this);
  } else if (const auto* heat = std::get_if<firmware_link::SetTemperature>(&command)) {
    const bool nozzle = heat->heater == firmware_link::Heater::kNozzle;
    (nozzle ? nozzle_tenths : bed_tenths) = heat->celsius_tenths;
  } else if (const auto* blow = std::get_if<firmware_link::SetFan>(&command)) {
    fan = blow->power;
  } else if (const auto* set = std::get_if<firmware_link::SetAcceleration>(&command)) {
    flavor = set->flavor;
    acceleration_mm_s2 = set->mm_s2;
  } else if (const auto* advance = std::get_if<firmware_link::SetPressureAdvance>(&command)) {
    flavor = advance->flavor;
    pressure_advance_tens_us = advance->tens_us;
  } else {
    x_um = y_um = z_um = f_mm_min = std::nullopt;
  }
}

std::vector<firmware_link::Command> MachineState::ways_of_moving() const {
  std::vector<firmware_link::Command> commands;
  if (pressure_advance_tens_us >= 0) {
    commands.emplace_back(firmware_link::SetPressureAdvance{flavor, pressure_advance_tens_us});
  }
  if (acceleration_mm_s2 > 0) {
    commands.emplace_back(firmware_link::SetAcceleration{flavor, acceleration_mm_s2});
  }
  return commands;
}

MachineState state_at(const Checkpoint& checkpoint, const core::Settings& settings) {
  MachineState state;
  state.x_um = checkpoint.encoder.x_um;
  state.y_um = checkpoint.encoder.y_um;
  state.z_um = checkpoint.encoder.z_um;
  state.f_mm_min = checkpoint.encoder.f_mm_min;
  if (checkpoint.motions.retracted) {
    state.drawn_back_10nm = filament_10nm(settings.retraction_mm);
  }
  state.nozzle_tenths = celsius_tenths(checkpoint.motions.nozzle_celsius);
  state.bed_tenths = celsius_tenths(checkpoint.motions.bed_celsius);
  state.flavor = checkpoint.encoder.flavor;
  if (checkpoint.motions.started && settings.pressure_advance_s >= 0) {
    state.pressure_advance_tens_us = pressure_advance_tens_us(settings.pressure_advance_s);
  }
  const double told_mm_s2 = checkpoint.motions.acceleration_mm_s2;
  if (told_mm_s2 > 0) state.acceleration_mm_s2 = acceleration_mm_s2(told_mm_s2);
  state.fan = fan_power(checkpoint.motions.fan);
  return state;
}

}  // namespace host
