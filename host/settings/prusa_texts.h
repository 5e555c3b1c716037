// Names in a profile of PrusaSlicer's family, as comments of a file have them.
#pragma once

#include <string>
#include <string_view>

namespace host {

// Without quotes, and escapes within them. They are for people and print hosts alone, so one that a
// setting can't hold (settings_table.h) is no error: it is left empty.
[[nodiscard]] std::string prusa_name_text(std::string_view text);

// Likewise, the first of several, with semicolons between them. Within quotes, a semicolon is part
// of the name.
[[nodiscard]] std::string first_prusa_name(std::string_view text);

}  // namespace host
