// Placeholders in a user's G-code, as PrusaSlicer has them, filled in with what is known.
//
//     M104 S[first_layer_temperature]              M104 S{first_layer_temperature[0]}
//     M104 S[first_layer_temperature_0]            M104 S{first_layer_temperature[initial_tool]}
//
// Only plain ones: a name, and which of its values. Conditions and arithmetic ({if …}, {a+1}) are
// no plain ones; nothing is guessed of them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"  // Result

namespace host {

// What stands for a name; nothing where it is not known, or has not so many values.
using PlaceholderValue =
    std::function<std::optional<std::string>(std::string_view name, std::size_t index)>;

enum class GcodeOrigin {
  kProfile,  // PrusaSlicer's: whatever stands in braces or brackets is a placeholder
  kOwn,      // braces may also hold what the controller works out (RepRapFirmware): it is left
};

// The lines without comments, each placeholder filled in. An error tells which one is not.
[[nodiscard]] core::Result<std::vector<std::string>> fill_placeholders(
    const std::vector<std::string>& lines, const PlaceholderValue& value, GcodeOrigin origin);

}  // namespace host
