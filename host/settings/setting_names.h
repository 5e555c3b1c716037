// Suggests a name for a setting that was typed wrong.
#pragma once

#include <string>
#include <string_view>

namespace host {

// A message: there is no such setting; then the most similar name, or its name in rind, or that
// only PrusaSlicer has it. `typed`: as typed; `key`: with '_' for '-'.
[[nodiscard]] std::string unknown_setting(std::string_view typed, std::string_view key);

}  // namespace host
