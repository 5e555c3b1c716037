// The one table of what a user can set: key, unit, default, range, help.
//
// Keys are the names in PrintSettings. `rind settings` prints the table; --set, profiles and the
// command line's own options all go through set_setting(), so that every value has been checked
// once, by the same rule, before it is used. PrusaSlicer's keys of the same meaning are understood
// too (settings_prusa.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"                   // Status
#include "host/pipeline/print_settings.h"  // PrintSettings

namespace host {

// One row of `rind settings`.
struct SettingRow {
  std::string key;
  std::string value;        // ENSURES: set_setting() reads it back to the same setting
  std::string plain_value;  // the same, a number where the value has a word for it ("auto": "0")
  std::string unit;         // "" where there is none
  std::string default_value;
  std::string range;
  std::string help;
};

// Sets one setting from what a user typed. '-' in a key is read as '_'.
//
// An error names the key, what was read, the range and the unit; for an unknown key, the nearest
// known one. ENSURES: after an error `settings` is as it was.
core::Status set_setting(PrintSettings& settings, std::string_view key, std::string_view text);

// In the order of PrintSettings.
[[nodiscard]] std::vector<SettingRow> describe_settings(const PrintSettings& settings);

// True for start and end G-code, in which ';' belongs to the value.
[[nodiscard]] bool is_gcode_setting(std::string_view key);

// Whether every setting is in its range and all of them fit together: the wall and the window, the
// road and the nozzle, the part's place and the bed. To be called once, before anything is made of
// them: REQUIRES of core's stages rest on it.
core::Status validate_settings(const PrintSettings& settings);

}  // namespace host
