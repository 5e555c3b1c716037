// PrusaSlicer's names for the settings of its relatives (OrcaSlicer, Bambu Studio) and of Cura, so
// that one translation (settings_prusa.h) serves all of them.
#pragma once

#include <string>
#include <string_view>

namespace host {

// PrusaSlicer's name of the same meaning; the name itself if it has none.
[[nodiscard]] std::string_view prusa_name(std::string_view foreign);

// The value of that setting as PrusaSlicer writes it: Cura's percentages and words.
[[nodiscard]] std::string prusa_value(std::string_view foreign, std::string_view value);

}  // namespace host
