// A profile as lines of keys and values, whatever its format was.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"                       // Result
#include "host/settings/gcode_placeholders.h"  // GcodeOrigin

namespace host {

// A larger file is no profile, but perhaps a model given by mistake. PrusaSlicer's largest bundle
// has 3 MB.
inline constexpr std::size_t kSettingsBytesMax = std::size_t{16} << 20;

// Profiles that inherit from one another.
inline constexpr int kInheritsMax = 32;

struct ProfileLine {
  std::string place;  // "file:line", or another place in the file
  std::string section;
  std::string key;
  std::string value;
};

// Which of a bundle's profiles are meant. Empty: the printer's own defaults.
struct ProfileChoice {
  std::string printer;
  std::string quality;
  std::string filament;
};

// Another program's profile, in PrusaSlicer's keys and values as far as there are any.
struct ForeignProfile {
  std::string program;  // "PrusaSlicer", "OrcaSlicer", "Cura"
  GcodeOrigin origin = GcodeOrigin::kProfile;
  std::vector<ProfileLine> lines;     // of one key, the last one counts
  std::vector<std::string> notes;     // what was chosen
  std::vector<ProfileLine> unsolved;  // expressions that are not understood
};

// "key = value" on each line, [section], comments from '#' or ';' at a line's start.
// REQUIRES: one call at a time: inih keeps its options in global variables.
[[nodiscard]] core::Result<std::vector<ProfileLine>> read_ini_lines(std::string_view text,
                                                                    const std::string& name);

[[nodiscard]] core::Error error_at(const ProfileLine& line, const std::string& message);

}  // namespace host
