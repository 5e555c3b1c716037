// Speeds and flows that a modifier asks for, in the words of PrusaSlicer and OrcaSlicer.
#pragma once

#include <string>
#include <string_view>

#include "core/settings.h"               // Settings
#include "core/slices/changed_areas.h"   // AreaChange
#include "host/formats/modifier_body.h"  // ModifierSettings

namespace host {

enum class ValueUse {
  kNone,    // no speed or flow, or one that can't be used
  kUsed,    // `change` has it
  kSilent,  // nothing to do, and nothing lost: it says that others count
};

// A share ("50%") is one of another of the modifier's settings, or else of the part's, as in the
// slicers. `words`: what is changed, for people.
[[nodiscard]] ValueUse read_laid_value(std::string_view key, const ModifierSettings& modifier,
                                       const core::Settings& settings, core::AreaChange& change,
                                       std::string& words);

// Bridges are as fast, and get as much, over the inside; and so fast are perimeters whose centre
// line is in the air, where the modifier does not say otherwise: as in a profile.
void complete_laid_values(const core::Settings& settings, core::AreaChange& change);

// With which nothing is changed.
[[nodiscard]] core::LaidValues own_laid_values(const core::Settings& settings);

}  // namespace host
