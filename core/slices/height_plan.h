// Decides the layers' heights, from the bed up:
//
//     first layer   first_layer_height
//     ranges        of height_range, their own (height_ranges.h); they win over all else
//     elsewhere     layer_height; or, adaptive, the greatest whole step (kHeightStep) within
//                   layer_height_min and layer_height_max that the ceiling allows from the
//                   layer's bottom to its top (height_ceiling.h); a little less below a flat face,
//                   so that a layer ends there
//
// A range starts where it says. The layers below it end there: whole ones as far as they go, then
// two or three equal ones for what is left, none higher than those, none lower than half of
// least_between_ranges(). Adaptive layers get lower towards a range of lower layers, as towards a
// slope. The last kLayersToFlat of them below a flat face (flat_faces.h) are made equal, as few as
// the ceiling allows, so that one ends there, to half a step; not where they would be lower than
// the least.
//
// At most kHeightBandsMax runs of equal layers are kept. If there are more, slopes and flat
// faces are looked at more coarsely: bins are made twice as wide until it fits, layers are lower
// than they could be, and end at fewer faces.
#pragma once

#include <cstdint>

#include "core/settings.h"              // Settings
#include "core/slices/height_limits.h"  // HeightLimits
#include "core/slices/layer_heights.h"  // LayerHeights
#include "core/units.h"                 // Length

namespace core {

// Layers below a flat face that are made to end there: no longer ones than that give up much.
inline constexpr LayerIndex kLayersToFlat = 8;

// Of layers that are not adaptive. REQUIRES: settings validated.
[[nodiscard]] LayerHeights layer_heights(const Settings& settings);

// Of adaptive ones, of a part from 0 up to `top`. `bed_z`: where its lowest point is in the heights
// that the limits were given. REQUIRES: settings validated, which have adaptive_limits().
// COSTS: O(bins + bands), however high the part.
[[nodiscard]] LayerHeights adaptive_heights(const Settings& settings, HeightLimits limits,
                                            std::int64_t bed_z, Length top);

}  // namespace core
