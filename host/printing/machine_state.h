// What the machine is told by a print's commands: where it is and how it is set after them.
#pragma once

#include <cstdint>
#include <optional>

#include "core/settings.h"               // Settings
#include "firmware_link/wire/command.h"  // Command
#include "host/pipeline/checkpoint.h"    // Checkpoint

namespace host {

struct MachineState {
  std::optional<std::int64_t> x_um, y_um, z_um;  // nothing: unknown, as after a user's own line
  std::optional<std::int64_t> f_mm_min;
  std::int64_t drawn_back_10nm = 0;  // of the filament
  std::int32_t nozzle_tenths = 0;    // targets
  std::int32_t bed_tenths = 0;
  std::uint8_t fan = 0;

  void apply(const firmware_link::Command& command);

  [[nodiscard]] bool placed() const { return x_um && y_um && z_um; }
};

// After all commands before the checkpoint's layer.
[[nodiscard]] MachineState state_at(const Checkpoint& checkpoint, const core::Settings& settings);

}  // namespace host
