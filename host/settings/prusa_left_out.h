// What of a PrusaSlicer profile rind does not do, though the print would be another with it.
//
// A profile never changes the print silently: each of these that asks for something is named with
// what happens instead. Keys that no part is printed differently by are not here.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace host {

// A profile's keys and values, as the file has them.
using ProfileValues = std::map<std::string, std::string, std::less<>>;

// Of a list with a value for each extruder, the first: without white space and quotation marks.
[[nodiscard]] std::string_view first_value(std::string_view text);

// A sentence for each thing: "brim_width = 5: no brim is laid".
[[nodiscard]] std::vector<std::string> left_out_of(const ProfileValues& profile);

// Whether it is a key that left_out_of() knows.
[[nodiscard]] bool is_left_out(std::string_view key);
[[nodiscard]] std::vector<std::string_view> left_out_keys();

}  // namespace host
