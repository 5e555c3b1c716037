// Fills in PrusaSlicer's placeholders in a user's G-code.
//
//     M104 S[first_layer_temperature]              M104 S{first_layer_temperature[0]}
//     M104 S[first_layer_temperature_0]            M104 S{first_layer_temperature[initial_tool]}
//
// Only plain placeholders are filled in: a name, and an index into its values. Conditions and
// arithmetic ({if …}, {a+1}) are errors.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"  // Result

namespace host {

// The text for a name; nullopt if the name is not known or has too few values.
using PlaceholderValue =
    std::function<std::optional<std::string>(std::string_view name, std::size_t index)>;

enum class GcodeOrigin {
  kProfile,  // PrusaSlicer's: anything in braces or brackets is a placeholder
  kOwn,      // braces may also hold an expression for the controller (RepRapFirmware): kept
};

// The lines without comments, with all placeholders filled in. The error names a placeholder that
// can't be.
[[nodiscard]] core::Result<std::vector<std::string>> fill_placeholders(
    const std::vector<std::string>& lines, const PlaceholderValue& value, GcodeOrigin origin);

}  // namespace host
