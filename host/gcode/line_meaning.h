// What a line of a ready G-code file means, and whether it may be sent.
//
//     "N12 g1 X5 E.03*34"  ──>  sent as "G1 X5 E.03";  a move to X 5 mm with 0.03 mm of filament
//
// A line number and a checksum of the file's own are left out, because the link numbers lines; a
// checksum that does not fit is an error. Words that are sent have capital letters, as
// verbatim_from() says.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"                 // Result
#include "firmware_link/wire/command.h"  // Flavor, ReadyLine
#include "host/gcode/gcode_modes.h"      // GcodeModes

namespace host {

struct MeaningRules {
  // In Marlin, G90 and G91 decide about the filament, too.
  firmware_link::Flavor flavor = firmware_link::Flavor::kMarlin;
  std::vector<std::string> allowed;  // commands that the user allows (refused_commands.h)
  bool checks = true;                // false: the file was checked before
};

struct LineMeaning {
  firmware_link::ReadyLine line;
  bool sets_up = false;  // set_up_lines.h
  bool macro = false;    // a name of which nothing is known
};

// `text`: without its comment. nullopt: nothing is to be sent. An error says why the line may not
// be sent. `modes` are those before the line, and those behind it on return.
[[nodiscard]] core::Result<std::optional<LineMeaning>> meaning_of(std::string_view text,
                                                                  const MeaningRules& rules,
                                                                  GcodeModes& modes);

// What M220 and M221 set; of other lines nothing. `line`: as verbatim_from() takes it.
[[nodiscard]] firmware_link::Effect percent_set_by(std::string_view line);

}  // namespace host
