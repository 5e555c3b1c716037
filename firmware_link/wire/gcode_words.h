// Which commands a line of G-code holds, however it is written.
//
//     "m0500"            M500        "G1 X5 M500"       G1 M500 (RepRapFirmware runs both)
//     "M 500.0 (now)"    M500        "firmware_restart" FIRMWARE_RESTART
//
// Firmwares differ: Marlin passes over blanks behind the letter and zeros before the number,
// RepRapFirmware and Smoothieware run several commands in one line. A command counts when any of
// them would run it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace firmware_link {

// Without what stands behind a semicolon and between parentheses; where the command carries a text
// (M117 …) parentheses behind it belong to that. Nothing is left of a line that starts with // or
// with @ (a word to OctoPrint, which no controller gets). White space around it is gone, tabs are
// blanks.
[[nodiscard]] std::string without_comments(std::string_view line);

// The length of the command word at the start: "G1", "M 500.0", "BED_MESH_PROFILE"; up to the first
// blank where it is neither a letter and a number nor a name. 0 for an empty text.
[[nodiscard]] std::size_t command_word_size(std::string_view text);

// True for a letter and a number, as all of classic G-code has it.
[[nodiscard]] bool is_classic(std::string_view command_word);

// A classic word's letter and whole number ("M500"), a name in capitals ("RESTART").
[[nodiscard]] std::string canonical(std::string_view command_word);

// Commands whose parameter is a text of the user's, to be left as it is.
[[nodiscard]] bool carries_text(std::string_view canonical_word);

// The first command and all others in the line, in canonical form. What stands between quotation
// marks, in a carried text or behind a name is no command. Comments may be there.
[[nodiscard]] std::vector<std::string> commands_in(std::string_view line);

// Whether a classic line has this parameter, as E in "G1 X5 E1". REQUIRES: a capital letter.
[[nodiscard]] bool has_parameter(std::string_view line, char letter);

}  // namespace firmware_link
