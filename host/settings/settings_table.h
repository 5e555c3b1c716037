// The table of all settings: key, unit, default, range, help.
//
// Keys are the names in PrintSettings. `rind settings` prints the table. --set, profiles and the
// command line's shortcuts all use set_setting(), so every value is checked by the same rule before
// it is used. PrusaSlicer's keys with the same meaning are understood, too (settings_prusa.h).
#pragma once

#include <optional>
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
  std::string plain_value;  // the same, with a number instead of a word ("auto": "0")
  std::string unit;         // may be empty
  std::string default_value;
  std::string range;
  std::string help;
  std::string_view type{};  // "number", "integer", "switch", "word", "text", "lines", "corners"
  std::optional<double> min{}, max{};  // of numbers
  std::vector<std::string> words{};    // all of a word's values, or those a number may have besides
};

// The values of a setting that takes one of a few words; empty for others, and unknown ones.
[[nodiscard]] std::vector<std::string> setting_words(std::string_view key);

// Sets one setting from what a user typed. '-' in a key is read as '_'.
//
// An error names the key, the text, the range and the unit; for an unknown key, the most similar
// known one. ENSURES: after an error, `settings` is unchanged.
core::Status set_setting(PrintSettings& settings, std::string_view key, std::string_view text);

// All rows, in the order of PrintSettings.
[[nodiscard]] std::vector<SettingRow> describe_settings(const PrintSettings& settings);

// True for start and end G-code, where ';' is part of the value.
[[nodiscard]] bool is_gcode_setting(std::string_view key);

// Checks that every setting is in its range and that all of them fit together: wall and window,
// road and nozzle, the part's position and the bed. Call it once before the settings are used:
// core's stages REQUIRE it.
core::Status validate_settings(const PrintSettings& settings);

}  // namespace host
