// Cura's profiles: definitions of printers (.def.json), and instances of settings (.inst.cfg, and
// the same in a .curaprofile).
//
// Values are numbers, words, texts, or expressions of other settings. Expressions that
// gcode_expression.h understands are worked out; others are named. The ancestors of all
// definitions (fdmprinter, fdmextruder) are not read: rind's own defaults hold.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"                  // Result
#include "host/settings/profile_lines.h"  // ForeignProfile, ProfileLine

namespace host {

// Whether a JSON file is a definition, and lines of an INI file are an instance.
[[nodiscard]] bool is_cura_definition(std::string_view text);
[[nodiscard]] bool is_cura_instance(const std::vector<ProfileLine>& lines);

// What it inherits is sought beside the file. `name`: its path.
[[nodiscard]] core::Result<ForeignProfile> read_cura_definition(std::string_view text,
                                                                const std::string& name);

[[nodiscard]] core::Result<ForeignProfile> read_cura_instance(const std::vector<ProfileLine>& lines,
                                                              const std::string& name);

}  // namespace host
