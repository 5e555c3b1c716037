// Where a machine can move: as the settings say, and as its controller tells. Parking, priming and
// lifting stay within both. A part that does not fit is refused before anything moves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"                     // Box, Point
#include "core/result.h"                       // Status
#include "core/settings.h"                     // Settings
#include "firmware_link/wire/command.h"        // Move
#include "firmware_link/wire/travel_limits.h"  // TravelLimits

namespace host {

struct MachineSpace {
  core::Length bed_x;
  core::Length bed_y;
  core::Length axis_z;                   // 0: not limited
  bool guessed = false;                  // the user has not said how large the bed is
  std::vector<core::Point> bed_shape{};  // as in the settings
};

[[nodiscard]] MachineSpace space_of(const core::Settings& settings);

// The settings with that space: for parking and lifting.
[[nodiscard]] core::Settings with_space(core::Settings settings, const MachineSpace& space);

// What lies in both. The limits count from the bed's front left corner.
[[nodiscard]] MachineSpace within(MachineSpace space, const firmware_link::TravelLimits& limits);

// What the user should know of it; may be empty. `limits`: nothing, where the controller tells
// none.
[[nodiscard]] std::string space_note(const MachineSpace& space,
                                     const std::optional<firmware_link::TravelLimits>& limits);

// The same limits, counted from the bed's front left corner.
[[nodiscard]] firmware_link::TravelLimits from_bed(firmware_link::TravelLimits limits,
                                                   const core::Settings& settings);

// The part in the printer's coordinates. REQUIRES: it counts from the bed's front left corner.
[[nodiscard]] core::Box on_machine(const core::Box& part, const core::Settings& settings);

// Whether the part lies within the limits, both in the printer's coordinates. An empty box: not
// known, and fits.
[[nodiscard]] core::Status check_travel(const core::Box& part, core::Length height,
                                        const firmware_link::TravelLimits& limits);

// Whether the move ends within them.
[[nodiscard]] bool within_travel(const firmware_link::Move& move,
                                 const firmware_link::TravelLimits& limits);

}  // namespace host
