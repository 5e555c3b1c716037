// Recognises ready G-code by its content, never by its name.
//
//     text   behind comments (;) comes a line that starts with G, M, T or N and a number; names of
//            macros (START_PRINT) may come before it
//     bgcode starts with "GCDE"
#pragma once

#include <optional>

#include "core/result.h"            // Result
#include "host/files/input_file.h"  // InputFile

namespace host {

enum class GcodeKind { kText, kBinary };

// nullopt: something else. Reads only as far as needed, and skips nothing.
[[nodiscard]] core::Result<std::optional<GcodeKind>> gcode_kind(InputFile& file);

}  // namespace host
