// The user's own G-code, before and behind the print, between rind's own modes.
//
// A print counts in millimetres, absolute places and relative filament. The user's lines may count
// otherwise: they begin as a controller does that was just switched on, and what they leave behind
// is set back.
//
//     G21 G90 M82   start G-code   G21 G90 M83 G92 E0   the print   (G92 E0)   end G-code
//
// Set back besides, where the start G-code changed it: the plane of arcs (G17), feeds in mm/min
// (G94), Celsius (M149 C), filament by its length (M200 D0), retraction by rind (M209 S0). Not
// set back is what a user has changed on purpose and what the part is printed with: offsets
// (G92 X…, G55), factors (M220, M221), the tool (T1), limits (M203 …). user_gcode_notes() names
// what of that changes the part.
#pragma once

#include <string>
#include <vector>

#include "core/result.h"    // Result, Status
#include "core/settings.h"  // Settings

namespace host {

// The commands that the user allows by `allow_gcode` ("M500,M501"), in the link's spelling. An
// error names what is no command, or is never allowed.
[[nodiscard]] core::Result<std::vector<std::string>> allowed_commands(const std::string& text);

// Whether all the user's own lines (start and end G-code) may be sent; else which one may not, and
// why, and what to do. Asked before anything heats.
[[nodiscard]] core::Status check_user_gcode(const core::Settings& settings);

// What the user's lines change for the whole print, a sentence each.
[[nodiscard]] std::vector<std::string> user_gcode_notes(const core::Settings& settings);

// What sets back what some of the user's lines changed, besides units, absolute places and relative
// filament; empty mostly.
[[nodiscard]] std::vector<std::string> restored_after(const std::vector<std::string>& lines);

// The same settings, with the modes in start_gcode and end_gcode.
[[nodiscard]] core::Settings with_own_modes(core::Settings settings);

}  // namespace host
