// What of a layer is to be held, by itself and by what people have marked (SupportMarks):
//
//     (what hangs by itself  ∪  all that is over no part of the slice below, where it is enforced)
//                            −  what is blocked
//
// Enforced is what hangs at all, whatever its angle, bridges too. Where both marks are, it is
// blocked.
//
// SOURCE: as PrusaSlicer's, but there an enforcer wins.
#pragma once

#include "core/regions/region.h"            // Region
#include "core/settings.h"                  // Settings
#include "core/slices/slice.h"              // SupportMarks
#include "core/supports/hanging_regions.h"  // HangingRegions
#include "core/units.h"                     // Length

namespace core {

struct MarkedHanging : HangingRegions {
  Region enforced;  // of the overhangs: it is held however small it is
};

// `by_itself`: whether it is held where nothing is marked. `marks`: of the slice; null: none.
// COSTS: hanging_regions() if it is; and with marks a few booleans.
[[nodiscard]] MarkedHanging marked_hanging(const Region& slice, const Region& below, Length planes,
                                           bool by_itself, const SupportMarks* marks,
                                           const Settings& settings);

}  // namespace core
