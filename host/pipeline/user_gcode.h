// The user's start and end G-code, and the modes that rind sets around them.
//
// A print uses millimetres, absolute positions and relative filament. The user's lines may use
// other modes: they start in the modes of a controller that was just switched on, and the modes
// that they change are restored.
//
//     G21 G90 M82   start G-code   G21 G90 M83 G92 E0   the print   (G92 E0)   end G-code
//     retract, lift   the lines of at_height   G21 G90 M83 G92 E0 M400   the print
//
// Lines at a height start in the modes of the print. M400 behind them: what comes before it is done
// for good, so that a resumed print never repeats it.
//
// Also restored, if the lines changed it: the plane of arcs (G17), feeds in mm/min (G94),
// Celsius (M149 C), filament by its length (M200 D0), retraction by rind (M209 S0). The tool (T1),
// M220, M221, M204 and pressure advance that start G-code sets stay, and are told again behind
// later lines that change them (standing_values.h). Not restored: offsets (G92 X…, G55), limits
// (M203 …). user_gcode_notes() names what changes the part.
#pragma once

#include <string>
#include <vector>

#include "core/result.h"    // Result, Status
#include "core/settings.h"  // Settings

namespace host {

// The commands that the user allows by `allow_gcode` ("M500,M501"), in the link's spelling. Errors:
// a word that is no command; a command that is never allowed.
[[nodiscard]] core::Result<std::vector<std::string>> allowed_commands(const std::string& text);

// Error if one of the user's lines (start, end, at heights, in pauses) must not be sent; it says
// which, why, and what to do. Called before anything heats.
[[nodiscard]] core::Status check_user_gcode(const core::Settings& settings);

// The lasting changes that the user's lines make to the print, one sentence each.
[[nodiscard]] std::vector<std::string> user_gcode_notes(const core::Settings& settings);

// Commands that restore what these lines changed, other than units, absolute positions and relative
// filament. Mostly empty.
[[nodiscard]] std::vector<std::string> restored_after(const std::vector<std::string>& lines);

// The same settings, with the commands for the modes added to start_gcode, at_height and
// end_gcode. REQUIRES: check_user_gcode() was fine, and so are the settings.
[[nodiscard]] core::Settings with_own_modes(core::Settings settings);

}  // namespace host
