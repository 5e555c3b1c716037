// What passes from the walls to the roads: a layer split into its wall and its inside.
#pragma once

#include "core/offsets/layer_offsets.h"  // Layer
#include "core/regions/region.h"         // Region

namespace core {

// solid ∪ loose = layer.slice.region, solid ∩ loose = ∅.
struct SplitLayer {
  Layer layer;
  Region solid;  // the wall: filled densely
  Region loose;  // the inside
};

}  // namespace core
