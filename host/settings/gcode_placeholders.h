// Fills in the placeholders in a profile's G-code, and in a user's own.
//
//     M104 S[first_layer_temperature]              M104 S{first_layer_temperature[0] - 20}
//     M104 S[first_layer_temperature_0]            G1 Z{min(max_layer_z + 5, max_print_height)}
//     {if max_layer_z < 50}G1 Z50{elsif layer_height < 0.1}G1 Z60{else}G1 Z70{endif}
//
// gcode_expression.h says what may stand in braces. A name in brackets is written as the profile
// has it. A condition may reach over lines. Everything is bounded: kExpandedBytesMax,
// kExpressionDepthMax, and no loops.
#pragma once

#include <string>
#include <vector>

#include "core/result.h"                     // Result
#include "host/settings/gcode_expression.h"  // VariableLookup

namespace host {

enum class GcodeOrigin {
  kProfile,  // PrusaSlicer's and its relatives': anything in braces or brackets is a placeholder
  kCura,     // names in braces alone, which may have an extruder's number behind a comma
  kOwn,      // braces may also hold an expression for the controller (RepRapFirmware): kept
};

// The lines without comments and empty lines, with all placeholders filled in. Conditions count in
// comments, too, as they do in PrusaSlicer; other placeholders there are left alone. The error has
// line and column, and names the placeholder.
[[nodiscard]] core::Result<std::vector<std::string>> fill_placeholders(
    const std::vector<std::string>& lines, const VariableLookup& lookup, GcodeOrigin origin);

}  // namespace host
