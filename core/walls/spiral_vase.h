// A spiral vase: over a floor as thick as the wall, the part is one perimeter that rises without a
// seam. It has no inside, no holes and no top, so only the largest contour of a slice counts.
//
//     ║        ║
//     ║        ║    one perimeter, turn after turn (roads/vase_roads.h)
//     ║▒▒▒▒▒▒▒▒║
//     ║▒▒▒▒▒▒▒▒║    the floor: layers that begin below wall_thickness
#pragma once

#include "core/regions/region.h"     // Region
#include "core/settings.h"           // Settings
#include "core/slices/slice.h"       // Slice
#include "core/units.h"              // Length
#include "core/walls/split_layer.h"  // SplitLayer

namespace core {

// Whether a layer that begins at `bottom` is above the floor of a vase. False without one.
[[nodiscard]] inline bool in_vase(Length bottom, const Settings& settings) {
  return settings.spiral_vase && bottom >= settings.wall_thickness;
}

[[nodiscard]] inline bool in_vase(const Slice& slice, const Settings& settings) {
  return in_vase(slice.bottom, settings);
}

// Whether it is the lowest layer above the floor.
[[nodiscard]] inline bool starts_vase(const SplitLayer& layer, const Settings& settings) {
  return in_vase(layer.slice, settings) &&
         (!layer.below || !in_vase(layer.slice.bottom - layer.below_height, settings));
}

// Whether the layer below is above the floor, too.
[[nodiscard]] inline bool over_vase(const SplitLayer& layer, const Settings& settings) {
  return in_vase(layer.slice, settings) && layer.below && !starts_vase(layer, settings);
}

// The contour with the most area, without its holes; empty where the region is.
[[nodiscard]] Region largest_contour(const Region& region);

// What is laid of a slice above the floor: one road inside its contours. COSTS: an offset.
[[nodiscard]] Region vase_ring(const Region& slice, const Settings& settings);

}  // namespace core
