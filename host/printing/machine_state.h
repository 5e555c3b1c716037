// The machine as a print's commands have set it: position, feed, temperatures, fan,
// accelerations, pressure advance.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/settings.h"               // Settings
#include "firmware_link/wire/command.h"  // Command
#include "host/pipeline/checkpoint.h"    // Checkpoint

namespace host {

struct MachineState {
  std::optional<std::int64_t> x_um, y_um, z_um;  // nothing: unknown, as after user G-code
  std::optional<std::int64_t> f_mm_min;
  std::int64_t drawn_back_10nm = 0;  // of the filament
  std::int32_t nozzle_tenths = 0;    // targets
  std::int32_t bed_tenths = 0;
  std::uint8_t fan = 0;
  firmware_link::Flavor flavor = firmware_link::Flavor::kMarlin;
  std::int32_t acceleration_mm_s2 = 0;         // 0: the machine's own, never told
  std::int32_t pressure_advance_tens_us = -1;  // negative: likewise

  void apply(const firmware_link::Command& command);

  // What tells a controller how it was told to move; empty: nothing was.
  [[nodiscard]] std::vector<firmware_link::Command> ways_of_moving() const;

  [[nodiscard]] bool position_known() const { return x_um && y_um && z_um; }
};

// After all commands before the checkpoint's layer.
[[nodiscard]] MachineState state_at(const Checkpoint& checkpoint, const core::Settings& settings);

}  // namespace host
