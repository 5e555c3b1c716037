// Moves off the part and back to it, as commands between those of the print.
//
//     leave_part    draw back, lift by park_lift, travel to the parking position
//     restart       after a reset: heat, draw back, lift, home X and Y only, travel to the parking
//                   position
//     come_back     return the filament and push out kPrime_mm more, draw back, travel to above the
//                   road's next point, go down, return the filament, set fan, acceleration and
//                   feed as they were
//
// A ready file may be in other modes than these moves: they begin with their own, and end with the
// file's (MachineState::own_modes).
//
//        ┌──────── travel ────────┐
//        │ lift                   │ down
//     ▂▂▂│▂▂▂ layer ▂▂▂▂▂▂▂▂▂▂▂▂▂▂▼▂▂▂
//
// Z is never homed: the part is in the way. Nothing is laid while x or y moves.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry.h"                // Box
#include "core/settings.h"                // Settings
#include "firmware_link/wire/command.h"   // Command
#include "host/printing/machine_state.h"  // MachineState

namespace host {

// Filament that is pushed out at the parking position before the print resumes, because a hot
// nozzle has oozed, and how fast.
inline constexpr double kPrime_mm = 4;
inline constexpr double kPrimeSpeed_mm_s = 4;

// Where the nozzle waits off the part, in the printer's coordinates.
struct ParkingPosition {
  std::int64_t x_um = 0;
  std::int64_t y_um = 0;
};

// park_x and park_y; where they are not set, those of the bed's corner that is farthest from the
// part, a little inside. `part` counts from the bed's
// front left corner. An empty box: the first corner.
[[nodiscard]] ParkingPosition parking_position(const core::Settings& settings,
                                               const core::Box& part);

class ParkMoves {
 public:
  ParkMoves(const core::Settings& settings, ParkingPosition position)
      : settings_(settings), position_(position) {}

  // `here`: the machine as the print's commands so far have set it. Empty where its position is not
  // known, which is before the first road, after the last, and behind lines of the user's.
  [[nodiscard]] std::vector<firmware_link::Command> leave_part(const MachineState& here) const;

  // `reheat`: the nozzle has cooled.
  [[nodiscard]] std::vector<firmware_link::Command> come_back(const MachineState& here,
                                                              bool reheat) const;

  // For a controller that may have forgotten everything. `nozzle_z_um`: how high the nozzle is; the
  // controller is told by `height_command` (LinkRules::height_command), unless that is empty. Lines
  // of the start G-code that set the controller up and move nothing (M92, M220, M420 …) are sent
  // again, and what the print told it of acceleration and pressure advance. `file_set_up`: of a
  // ready file, such lines of its own instead (SetUpLines).
  [[nodiscard]] std::vector<firmware_link::Command> restart(
      const MachineState& here, std::int64_t nozzle_z_um, std::string_view height_command,
      const std::vector<std::string>& file_set_up = {}) const;

 private:
  core::Settings settings_;
  ParkingPosition position_;
};

}  // namespace host
