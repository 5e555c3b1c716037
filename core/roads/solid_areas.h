// Which parts of the wall lie under the open sky, and which over nothing.
//
//            ┌──────┐          Only places wider than kTopRoadsMin roads count: the crescents that
//      ______│      │______    each layer of a slope shows stay wall. A top reaches half as far
//     │  top │ wall │ top  │   under the layer above, so that no slit opens along its edge.
#pragma once

#include "core/regions/region.h"     // Region
#include "core/settings.h"           // Settings
#include "core/walls/split_layer.h"  // SplitLayer

namespace core {

// Narrower tops and bottoms are wall.
inline constexpr double kTopRoadsMin = 3;

// Disjoint. The bed holds the first layer, whose underside is seen: it is bottom, too.
struct SolidAreas {
  Region top;
  Region bottom;
  Region between;  // neither
};

// `wall`: what of the layer is to be filled densely, without bridges.
// COSTS: nothing where the slices over and under it are the same; else some booleans and offsets.
[[nodiscard]] SolidAreas solid_areas(Region wall, const SplitLayer& layer,
                                     const Settings& settings);

}  // namespace core
