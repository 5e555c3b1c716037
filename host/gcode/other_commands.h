// What the commands of a file do that are no plain moves: modes, temperatures, fans, tools, and
// where they leave the nozzle.
#pragma once

#include <string_view>

#include "firmware_link/wire/command.h"  // Flavor, ReadyLine
#include "host/gcode/gcode_modes.h"      // GcodeModes

namespace host {

struct CommandWords {
  std::string_view command;     // in canonical form (gcode_words.h)
  std::string_view text;        // the whole line
  std::string_view parameters;  // behind the command's word
  firmware_link::Flavor flavor;
};

enum class CommandKnown {
  kYes,
  kMacro,  // a name that stands for lines of the printer's own
};

// Puts what the command does into the line. `modes`: those before it; of them only
// filament_mode_unclear is changed, which no line says.
//
// What is not known is taken to bring the nozzle back once roads are laid: the file itself goes on
// from there. Before that, it is taken to leave the nozzle anywhere.
CommandKnown read_command(const CommandWords& words, GcodeModes& modes,
                          firmware_link::ReadyLine& line);

}  // namespace host
