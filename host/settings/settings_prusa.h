// Translates PrusaSlicer's settings into ours, if they mean the same.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace host {

// One of our keys, and the text to set it to.
struct SettingText {
  std::string key;
  std::string text;
};

// Our settings for one of theirs. An empty list: the key is known, but this value has no
// counterpart (an automatic width or speed, a percentage of another setting, a bed that
// is no outline). Nullopt: the key has no counterpart. G-code keeps its placeholders.
// From a list with a value for each extruder, the first is used.
[[nodiscard]] std::optional<std::vector<SettingText>> from_prusa(std::string_view key,
                                                                 std::string_view text);

// PrusaSlicer's keys that from_prusa() knows.
[[nodiscard]] std::vector<std::string_view> prusa_keys();

// Our key for one of theirs with the same numeric value.
[[nodiscard]] std::optional<std::string_view> ours_for(std::string_view key);

// PrusaSlicer's defaults for cooling, and whether a key is about cooling.
[[nodiscard]] std::vector<SettingText> prusa_cooling();
[[nodiscard]] bool is_prusa_cooling(std::string_view key);

// True for a few keys that every PrusaSlicer or Slic3r profile has and that rind does not use: a
// file with several of them is such a profile.
[[nodiscard]] bool is_prusa_hallmark(std::string_view key);

}  // namespace host
