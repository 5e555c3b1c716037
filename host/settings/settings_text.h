// How the values of settings are written: numbers, shares, switches, lines of G-code.
//
// Every reader takes the whole text or says where it stopped; every writer is read back to the same
// value. Numbers use a decimal point, whatever the machine's locale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"                // Result
#include "firmware_link/wire/limits.h"  // kTextBytesMax

namespace host {

// A line of the user's G-code: what the link can number and send.
inline constexpr std::size_t kVerbatimBytesMax = firmware_link::kTextBytesMax;
// Lines of start or end G-code.
inline constexpr std::size_t kVerbatimLinesMax = 1'000;

// The text without white space around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

// A finite number; `unit` may stand behind it ("0.2", "0.2 mm"). "%" as unit gives a share: "20%"
// and "0.2" are the same. Errors say what was read, not which setting: the caller knows that.
[[nodiscard]] core::Result<double> read_number(std::string_view text, std::string_view unit);

[[nodiscard]] core::Result<std::int64_t> read_whole_number(std::string_view text);

// 1/0, true/false, yes/no, on/off.
[[nodiscard]] core::Result<bool> read_switch(std::string_view text);

// At most so many characters in a setting that is a list of words.
inline constexpr std::size_t kWordsBytesMax = 1'000;

// Lines with "\n" between them, "\\" for a backslash, as PrusaSlicer writes them. Comments and
// empty lines are dropped: they never reach the controller. An error names a line that is too long
// or not ASCII. Which commands may be sent is asked elsewhere (user_gcode.h).
[[nodiscard]] core::Result<std::vector<std::string>> read_lines(std::string_view text);

// The two halves of read_lines(): all lines, comments too, and the same without what is not sent.
[[nodiscard]] std::vector<std::string> unescaped_lines(std::string_view text);
[[nodiscard]] core::Result<std::vector<std::string>> sendable_lines(
    const std::vector<std::string>& lines);

// Whether all of it is printable ASCII.
[[nodiscard]] bool is_printable(std::string_view text);

// The shortest text that reads back as the same number.
[[nodiscard]] std::string write_number(double number);
[[nodiscard]] std::string write_lines(const std::vector<std::string>& lines);

}  // namespace host
