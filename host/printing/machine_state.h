// The machine as a print's commands have set it: position, feed, temperatures, fan,
// accelerations, pressure advance.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/settings.h"               // Settings
#include "firmware_link/wire/command.h"  // Command
#include "host/pipeline/checkpoint.h"    // Checkpoint

namespace host {

struct MachineState {
  std::optional<std::int64_t> x_um, y_um, z_um;  // nothing: unknown, as after user G-code
  std::optional<std::int64_t> f_mm_min;
  std::int64_t drawn_back_10nm = 0;  // of the filament
  std::int64_t highest_laid_um = 0;  // at which a road was laid: what is finished may stand higher
  std::int32_t nozzle_tenths = 0;    // targets
  std::int32_t bed_tenths = 0;
  std::uint8_t fan = 0;
  firmware_link::Flavor flavor = firmware_link::Flavor::kMarlin;
  std::int32_t acceleration_mm_s2 = 0;         // 0: the machine's own, never told
  std::int32_t pressure_advance_tens_us = -1;  // negative: likewise

  // Of a ready file: the modes that it is in (Effect), what the controller counts of filament, and
  // what it has changed. A part has rind's own modes.
  std::int32_t file_modes = firmware_link::Effect::kRelativeFilament;
  std::int64_t e_count_10nm = 0;
  std::int32_t feed_percent = 100;
  std::int32_t flow_percent = 100;
  bool shifted = false;  // its coordinates are not the machine's own

  void apply(const firmware_link::Command& command);

  // What tells a controller how it was told to move; empty: nothing was.
  [[nodiscard]] std::vector<firmware_link::Command> ways_of_moving() const;

  [[nodiscard]] bool position_known() const { return x_um && y_um && z_um; }

  // Millimetres, absolute positions and relative filament, which moves of rind's own need; and what
  // restores the file's modes behind these. Empty where the file is in these modes.
  [[nodiscard]] std::vector<firmware_link::Command> own_modes() const;
  [[nodiscard]] std::vector<firmware_link::Command> file_modes_again() const;
};

// A line of G-code as a command. REQUIRES: it is one.
[[nodiscard]] firmware_link::Command command_of(const std::string& line);

// After all commands before the checkpoint's layer.
[[nodiscard]] MachineState state_at(const Checkpoint& checkpoint, const core::Settings& settings);

}  // namespace host
