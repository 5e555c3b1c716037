// Moves of a file (G0 … G3) and what they mean, whatever modes the file is in.
#pragma once

#include "firmware_link/wire/command.h"  // ReadyLine
#include "host/gcode/gcode_modes.h"      // GcodeModes
#include "host/gcode/gcode_numbers.h"    // GcodeNumbers

namespace host {

// Puts the move into the line. `code`: 0 … 3.
void read_move(int code, const GcodeNumbers& numbers, const GcodeModes& modes,
               firmware_link::ReadyLine& line);

// A length in the file's unit as µm, and filament as 10 nm. REQUIRES: in units of 0.00001.
[[nodiscard]] std::int64_t um_in(std::int64_t fixed, const GcodeModes& modes);
[[nodiscard]] std::int64_t filament_10nm_in(std::int64_t fixed, const GcodeModes& modes);

}  // namespace host
