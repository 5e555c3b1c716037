// What a user who typed a setting's name wrong may have meant.
#pragma once

#include <string>
#include <string_view>

namespace host {

// A sentence that says that there is no such setting, and the nearest one, what it is called here,
// or that PrusaSlicer has it and rind does not. `typed`: as it was; `key`: with '_' for '-'.
[[nodiscard]] std::string unknown_setting(std::string_view typed, std::string_view key);

}  // namespace host
