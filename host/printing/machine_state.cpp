#include "host/printing/machine_state.h"

#include <fmt/format.h>

#include <variant>

#include "core/check.h"                   // RIND_CHECK
#include "core/motions/height_actions.h"  // HeightActions
#include "host/gcode/gcode_modes.h"
#include "host/gcode/line_meaning.h"  // percent_set_by
#include "host/pipeline/standing_values.h"
#include "host/pipeline/user_gcode.h"  // with_own_modes
#include "host/pipeline/wire_units.h"

namespace host {
namespace {

using firmware_link::Effect;
using firmware_link::Move;

void apply_move(const Move& move, MachineState& state) {
  if (move.x_um) state.x_um = move.x_um;
  if (move.y_um) state.y_um = move.y_um;
  if (move.z_um) state.z_um = move.z_um;
  if (move.f_mm_min) state.f_mm_min = move.f_mm_min;
  state.drawn_back_10nm = drawn_back_after(move, state.drawn_back_10nm);
  state.highest_laid_um = highest_laid_after(move, state.z_um, state.highest_laid_um);
}

// The two hold the same of a file; the state of a part's print has more.
GcodeModes modes_of(const MachineState& state) {
  GcodeModes modes;
  modes.x_um = state.x_um;
  modes.y_um = state.y_um;
  modes.z_um = state.z_um;
  modes.f_mm_min = state.f_mm_min;
  modes.e_count_10nm = state.e_count_10nm;
  modes.drawn_back_10nm = state.drawn_back_10nm;
  modes.highest_laid_um = state.highest_laid_um;
  modes.nozzle_tenths = state.nozzle_tenths;
  modes.bed_tenths = state.bed_tenths;
  modes.fan = state.fan;
  modes.modes = state.file_modes;
  modes.feed_percent = state.feed_percent;
  modes.flow_percent = state.flow_percent;
  modes.shifted = state.shifted;
  return modes;
}

void put_modes(const GcodeModes& modes, MachineState& state) {
  state.x_um = modes.x_um;
  state.y_um = modes.y_um;
  state.z_um = modes.z_um;
  state.f_mm_min = modes.f_mm_min;
  state.e_count_10nm = modes.e_count_10nm;
  state.drawn_back_10nm = modes.drawn_back_10nm;
  state.highest_laid_um = modes.highest_laid_um;
  state.nozzle_tenths = modes.nozzle_tenths;
  state.bed_tenths = modes.bed_tenths;
  state.fan = modes.fan;
  state.file_modes = modes.modes;
  state.feed_percent = modes.feed_percent;
  state.flow_percent = modes.flow_percent;
  state.shifted = modes.shifted;
}

void note_percent(const Effect& effect, MachineState& state) {
  const auto percent = static_cast<std::int32_t>(effect.value);
  if (effect.kind == Effect::Kind::kFeedPercent) state.feed_percent = percent;
  if (effect.kind == Effect::Kind::kFlowPercent) state.flow_percent = percent;
}

}  // namespace

firmware_link::Command command_of(const std::string& line) {
  auto made = firmware_link::verbatim_from(line);
  RIND_CHECK(std::holds_alternative<firmware_link::Verbatim>(made));
  return std::get<firmware_link::Verbatim>(made);
}

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
  } else if (const auto* ready = std::get_if<firmware_link::ReadyLine>(&command)) {
    // Nearly all of a file are moves, and this is asked often.
    const bool moves_alone = ready->effect.kind == Effect::Kind::kNone && !ready->shifted &&
                             ready->place != firmware_link::PlaceAfter::kAxesLost;
    if (moves_alone) {
      apply_move(ready->move, *this);
      e_count_10nm += ready->move.e_10nm.value_or(0);
      return;
    }
    GcodeModes modes = modes_of(*this);
    modes.apply(*ready);
    put_modes(modes, *this);
  } else {
    if (const auto* line = std::get_if<firmware_link::Verbatim>(&command)) {
      note_percent(percent_set_by(line->text()), *this);
    }
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

std::vector<firmware_link::Command> MachineState::own_modes() const {
  std::vector<firmware_link::Command> commands;
  if (file_modes == Effect::kRelativeFilament) return commands;
  if ((file_modes & Effect::kInches) != 0) commands.push_back(command_of("G21"));
  if ((file_modes & Effect::kRelativePlace) != 0) commands.push_back(command_of("G90"));
  commands.push_back(command_of("M83"));
  return commands;
}

std::vector<firmware_link::Command> MachineState::file_modes_again() const {
  std::vector<firmware_link::Command> commands;
  if (file_modes == Effect::kRelativeFilament) return commands;
  const double count_mm = static_cast<double>(e_count_10nm) * 1e-5;
  commands.push_back(command_of(fmt::format("G92 E{:.5f}", count_mm)));
  if ((file_modes & Effect::kRelativePlace) != 0) commands.push_back(command_of("G91"));
  const bool relative = (file_modes & Effect::kRelativeFilament) != 0;
  commands.push_back(command_of(relative ? "M83" : "M82"));
  if ((file_modes & Effect::kInches) != 0) commands.push_back(command_of("G20"));
  return commands;
}

MachineState state_at(const Checkpoint& checkpoint, const core::Settings& of_print) {
  MachineState state;
  if (checkpoint.file) {
    put_modes(checkpoint.file->modes, state);
    return state;
  }
  core::Settings settings = with_own_modes(of_print);
  core::HeightActions(settings).apply(static_cast<std::size_t>(checkpoint.motions.actions),
                                      settings);
  state.x_um = checkpoint.encoder.x_um;
  state.y_um = checkpoint.encoder.y_um;
  state.z_um = checkpoint.encoder.z_um;
  state.f_mm_min = checkpoint.encoder.f_mm_min;
  if (checkpoint.motions.retracted) {
    state.drawn_back_10nm = filament_10nm(settings.retraction_mm);
  }
  state.highest_laid_um = um_of(checkpoint.motions.highest.units());
  state.nozzle_tenths = celsius_tenths(checkpoint.motions.nozzle_celsius);
  state.bed_tenths = celsius_tenths(checkpoint.motions.bed_celsius);
  state.flavor = checkpoint.encoder.flavor;
  if (checkpoint.motions.started && settings.pressure_advance_s >= 0) {
    state.pressure_advance_tens_us = pressure_advance_tens_us(settings.pressure_advance_s);
  }
  if (checkpoint.motions.started) {
    const StandingValues standing(of_print);
    state.feed_percent = standing.feed();
    state.flow_percent = standing.flow();
  }
  const double told_mm_s2 = checkpoint.motions.acceleration_mm_s2;
  if (told_mm_s2 > 0) state.acceleration_mm_s2 = acceleration_mm_s2(told_mm_s2);
  state.fan = fan_power(checkpoint.motions.fan);
  return state;
}

}  // namespace host
