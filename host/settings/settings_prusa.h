// PrusaSlicer's keys that mean the same as ours, so that its profiles load.
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

// Ours for one of theirs. An empty list: the key is known, but this value has no counterpart here
// (an automatic width or speed, a percentage of another setting, a bed that is no rectangle along
// the axes). Nothing: the key has none. G-code is as it is, with its placeholders. Of lists with a
// value for each extruder, the first is taken.
[[nodiscard]] std::optional<std::vector<SettingText>> from_prusa(std::string_view key,
                                                                 std::string_view text);

// For a bed_shape that from_prusa() has nothing for: the bed as a rectangle within it. An empty
// list: there is none that is sure to be.
[[nodiscard]] std::vector<SettingText> rectangle_of_bed(std::string_view text);

// Their keys that from_prusa() knows.
[[nodiscard]] std::vector<std::string_view> prusa_keys();

// Ours for one of theirs that is the same number.
[[nodiscard]] std::optional<std::string_view> ours_for(std::string_view key);

// How PrusaSlicer cools where a profile does not say it, and whether a key says something of that.
[[nodiscard]] std::vector<SettingText> prusa_cooling();
[[nodiscard]] bool is_prusa_cooling(std::string_view key);

// True for a few keys that every PrusaSlicer or Slic3r profile holds and that we have no use for:
// a file with several of them is one of theirs.
[[nodiscard]] bool is_prusa_hallmark(std::string_view key);

}  // namespace host
