// What makes a nozzle safe, wherever it stands: drawn back, lifted off the part, and cold. Parking,
// restarting and every end of a print start with these.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/settings.h"                // Settings
#include "firmware_link/wire/command.h"   // Command
#include "host/printing/machine_state.h"  // MachineState

namespace host {

// How much filament a retraction draws back.
[[nodiscard]] std::int64_t retraction_10nm(const core::Settings& settings);

// How high the nozzle is lifted from there (core::park_height).
[[nodiscard]] std::int64_t lifted_um(std::int64_t z_um, const core::Settings& settings);

// The height that it is lifted from: its own, or that of what stands finished beside it, if that is
// higher. Nothing: its own is not known.
[[nodiscard]] std::optional<std::int64_t> lifted_from_um(const MachineState& here);

// Filament drawn back (0: not), then the nozzle lifted from `z_um` (nothing: not known, so it is
// not lifted).
[[nodiscard]] std::vector<firmware_link::Command> lift_off(std::int64_t draw_back_10nm,
                                                           std::optional<std::int64_t> z_um,
                                                           const core::Settings& settings);

// To where a print's end parks the nozzle, too (core::park_place). REQUIRES: it is lifted.
[[nodiscard]] firmware_link::Command park_move(const core::Settings& settings);

// Both heaters and the fan off. Nothing moves.
[[nodiscard]] std::vector<firmware_link::Command> heaters_off();

// The acceleration that the printer is left with, where it was told another one; otherwise empty.
[[nodiscard]] std::vector<firmware_link::Command> acceleration_given_back(
    const MachineState& here, const core::Settings& settings);

// The same for the factors of feed and flow that a ready file has set.
[[nodiscard]] std::vector<firmware_link::Command> percents_given_back(const MachineState& here);

// One move each, at a speed of its own.
[[nodiscard]] firmware_link::Command filament_move(std::int64_t by_10nm, double speed_mm_s);
[[nodiscard]] firmware_link::Command travel_move(std::int64_t x_um, std::int64_t y_um,
                                                 double speed_mm_s);
[[nodiscard]] firmware_link::Command lift_move(std::int64_t z_um, double speed_mm_s);

}  // namespace host
