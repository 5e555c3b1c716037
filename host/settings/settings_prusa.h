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
// (an automatic width, a percentage of another setting, a bed that is no rectangle at the origin,
// G-code with placeholders that only PrusaSlicer fills in). Nothing: the key has none.
// Of lists with a value for each extruder, the first is taken.
[[nodiscard]] std::optional<std::vector<SettingText>> from_prusa(std::string_view key,
                                                                 std::string_view text);

// Their keys that from_prusa() knows.
[[nodiscard]] std::vector<std::string_view> prusa_keys();

// True for a few keys that every PrusaSlicer or Slic3r profile holds and that we have no use for:
// a file with several of them is one of theirs.
[[nodiscard]] bool is_prusa_hallmark(std::string_view key);

}  // namespace host
