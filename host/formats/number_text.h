// Reads and writes the numbers of text files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace host {

// The whole of `text` as a finite number: 12, -0.5, +3, 1e-4, 000000.010. Nullopt if it is none.
[[nodiscard]] std::optional<double> parse_real(std::string_view text);

// The whole of `text` as an integer; nullopt if it is none.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text);

// Appends a length in grid units as mm, exactly: "12.3456", "0", "-0.05".
void append_mm(std::int64_t units, std::string& into);

// The same, always with a decimal point, for formats that require one: "12.0".
void append_real_mm(std::int64_t units, std::string& into);

// Appends it in inches, with the eight decimals needed to read the same length back.
void append_inches(std::int64_t units, std::string& into);

// "12.5", for messages.
[[nodiscard]] std::string number_text(double value);

}  // namespace host
