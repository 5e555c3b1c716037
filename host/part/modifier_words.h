// What a modifier's settings change here, and what they would change that rind can't do within a
// part of a layer.
#pragma once

#include <string>
#include <vector>

#include "core/settings.h"               // Settings
#include "core/slices/changed_areas.h"   // AreaChange
#include "host/formats/modifier_body.h"  // ModifierSettings

namespace host {

// As many perimeters as the settings allow.
inline constexpr int kAreaPerimetersMax = 50;

struct ModifierWords {
  core::AreaChange change;
  std::string used;    // "density 50 %, pattern gyroid"
  std::string unused;  // "perimeters, fill_pattern = hilbertcurve"; empty: nothing is lost

  [[nodiscard]] bool changes_nothing() const { return change == core::AreaChange(); }
};

// In PrusaSlicer's words or OrcaSlicer's. `settings`: of the part, since branches (lightning) can't
// be mixed with other patterns, what has no inside has nothing to change, and shares are of its
// values.
[[nodiscard]] ModifierWords read_modifier(const ModifierSettings& modifier,
                                          const core::Settings& settings);

// Of a part's modifiers: takes out what none of them wants otherwise than the part's own settings,
// so that a print does not know that they were there.
void leave_out_own(const core::Settings& settings, std::vector<ModifierWords>& all);

}  // namespace host
