// Settings of a PrusaSlicer profile that change the print and that rind does not support.
//
// A profile never changes the print silently: if one of these settings is in use, a message names
// it and says what happens instead. Keys that don't change the print are not listed.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace host {

// A profile's keys and values, as in the file.
using ProfileValues = std::map<std::string, std::string, std::less<>>;

// The first value of a list with one for each extruder, without white space and quotation marks.
[[nodiscard]] std::string_view first_value(std::string_view text);

// A setting in use, and what happens instead.
struct LeftOutRow {
  std::string_view key;
  std::string value;
  std::string_view instead;
};

[[nodiscard]] std::vector<LeftOutRow> left_out_rows(const ProfileValues& profile);

// A long value's start.
[[nodiscard]] std::string shortened_value(std::string_view value);

// A message for each setting in use: "brim_width = 5: no brim is laid".
[[nodiscard]] std::vector<std::string> left_out_of(const ProfileValues& profile);

// True for a key that left_out_of() knows.
[[nodiscard]] bool is_left_out(std::string_view key);
[[nodiscard]] std::vector<std::string_view> left_out_keys();

}  // namespace host
