// Regular expressions as PrusaSlicer's conditions have them: printer_notes=~/.*MINI.*/
//
// Known are characters, ".", classes ("[a-z]", "\d", "\w", "\s"), groups, "|", "*", "+", "?", and
// "^" and "$" at the ends. Time is bounded: no backtracking.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/result.h"  // Result

namespace host {

// A longer pattern, or text, is an error.
inline constexpr std::size_t kPatternBytesMax = 1'000;
inline constexpr std::size_t kMatchedBytesMax = 100'000;

// Whether the pattern matches the whole text. COSTS: O(pattern · text).
[[nodiscard]] core::Result<bool> matches_whole(std::string_view pattern, std::string_view text);

}  // namespace host
