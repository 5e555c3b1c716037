// Reads and writes the values of settings: numbers, fractions, switches, lines of G-code.
//
// A reader needs the whole text to be valid; its error says where reading stopped. Written values
// are read back as the same values. Numbers use a decimal point in every locale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"                // Result
#include "firmware_link/wire/limits.h"  // kTextBytesMax

namespace host {

// A line of the user's G-code: the longest that the link can number and send.
inline constexpr std::size_t kVerbatimBytesMax = firmware_link::kTextBytesMax;
// Such a line while placeholders stand in it.
inline constexpr std::size_t kPlaceholderLineBytesMax = 2'000;
// Lines of start or end G-code.
inline constexpr std::size_t kVerbatimLinesMax = 1'000;

// A finite number, which `unit` may follow ("0.2", "0.2 mm"). With the unit "%", "20%" and "0.2"
// are the same. The error does not name the setting.
[[nodiscard]] core::Result<double> read_number(std::string_view text, std::string_view unit);

[[nodiscard]] core::Result<std::int64_t> read_whole_number(std::string_view text);

// 1/0, true/false, yes/no, on/off.
[[nodiscard]] core::Result<bool> read_switch(std::string_view text);

// Characters of a setting that is a list of words.
inline constexpr std::size_t kWordsBytesMax = 1'000;

// Reads lines with "\n" between them and "\\" for a backslash, as PrusaSlicer writes them. Comments
// and empty lines are dropped: they are never sent. Error if a line is too long or not ASCII.
// user_gcode.h checks whether the commands may be sent.
[[nodiscard]] core::Result<std::vector<std::string>> read_lines(std::string_view text);

// The two steps of read_lines(): all lines, with comments; then only the lines that are sent.
[[nodiscard]] std::vector<std::string> unescaped_lines(std::string_view text);
[[nodiscard]] core::Result<std::vector<std::string>> sendable_lines(
    const std::vector<std::string>& lines);

// True if all of it is printable ASCII.
[[nodiscard]] bool is_printable(std::string_view text);

// The shortest text that reads back as the same number.
[[nodiscard]] std::string write_number(double number);
// Text of several lines as one: with "\\n" between them and "\\\\" for a backslash.
[[nodiscard]] std::string escaped(std::string_view text);
[[nodiscard]] std::string write_lines(const std::vector<std::string>& lines);

}  // namespace host
