// What passes from the walls to the roads: a layer, split into its wall and its inside.
#pragma once

#include "core/offsets/layer_offsets.h"  // Layer
#include "core/regions/region.h"         // Region

namespace core {

// solid ∪ loose = slice.region, solid ∩ loose = ∅.
struct SplitLayer : Layer {
  Region solid;  // the wall, which slicers call shell: filled densely
  Region loose;  // the inside: filled sparsely (infill)
};

}  // namespace core
