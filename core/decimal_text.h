// Reads words and decimal numbers from a line that a user typed, exactly: no number passes through
// a double.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace core {

// The text without blanks and tabs around it.
[[nodiscard]] std::string_view without_blanks(std::string_view text);

// The text up to the first blank or tab, which is taken off with those around it.
[[nodiscard]] std::string_view take_word(std::string_view& text);

// "12.4" with two decimals: 1240. Nothing: no such number, more decimals, or one above the largest.
[[nodiscard]] std::optional<std::int64_t> read_decimal(std::string_view text, int decimals,
                                                       std::int64_t largest);

}  // namespace core
