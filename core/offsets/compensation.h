// Makes contours larger or smaller, to make up for how a printer prints: plastic spreads, the more
// so in the first layer, which is pressed on the bed (elephant foot), and holes shrink.
//
// Keywords: XY size compensation, horizontal expansion, hole expansion, elephant foot.
#pragma once

#include "core/regions/region.h"  // Region
#include "core/settings.h"        // Settings
#include "core/slices/slice.h"    // Slice

namespace core {

[[nodiscard]] bool compensates(const Settings& settings);

// The slice as it is to be built. Outer contours move by contour_compensation, holes by
// hole_compensation (positive: smaller holes), and all those of the first layer inwards by
// elephant_foot_compensation, but for places that would become narrower than a road.
// COSTS: an offset or three; where contours and holes move differently, one for each contour, and
// a boolean.
[[nodiscard]] Region compensated(const Slice& slice, const Settings& settings);

}  // namespace core
