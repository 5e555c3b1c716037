// Commands that have no place in a print's G-code, each with its reason: the one list for profiles,
// settings and files.
//
// Some would break what keeps the print going: the count of lines, the connection, the motion that
// is under way. They are never sent. The others change the printer for good, or do harm: they are
// sent when the user has named them (`--allow-gcode M500,M501`).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace firmware_link {

struct RefusedCommand {
  std::string_view command;  // as canonical() has it; "D": every command with that letter
  bool never = false;        // not even when the user names it
  std::string_view reason;   // what it does: the rest of a sentence that starts with the command
};

// Nothing when the list does not have it. REQUIRES: as canonical() has it.
[[nodiscard]] std::optional<RefusedCommand> refused_command(std::string_view command);

// The first command in the line that may not be sent. `allowed`, in canonical form, opens those
// that are not refused for ever; nothing does for those.
[[nodiscard]] std::optional<RefusedCommand> refused_in(std::string_view line,
                                                       const std::vector<std::string>& allowed);

}  // namespace firmware_link
