// What a modifier's settings change here, and what they would change that rind can't do within a
// part of a layer.
#pragma once

#include <string>

#include "core/settings.h"               // Settings
#include "core/slices/slice.h"           // InsideChange
#include "host/formats/modifier_body.h"  // ModifierSettings

namespace host {

struct ModifierWords {
  core::InsideChange change;
  std::string used;    // "density 50 %, pattern gyroid"
  std::string unused;  // "perimeters, fill_pattern = hilbertcurve"; empty: nothing is lost

  [[nodiscard]] bool changes_nothing() const { return change == core::InsideChange(); }
};

// In PrusaSlicer's words or OrcaSlicer's. `settings`: of the part, since branches (lightning) can't
// be mixed with other patterns, and what has no inside has nothing to change.
[[nodiscard]] ModifierWords read_modifier(const ModifierSettings& modifier,
                                          const core::Settings& settings);

}  // namespace host
