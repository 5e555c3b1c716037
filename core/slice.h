// What passes between the stages: a slice, its offsets, and the layer split into wall and inside.
#pragma once

#include <cstdint>
#include <vector>

#include "core/region.h"  // Region
#include "core/units.h"   // LayerIndex, Length

namespace core {

// What was wrong with the mesh at one plane, and mended.
struct SliceDefects {
  std::int64_t closed_chains = 0;   // open chains closed across a gap
  std::int64_t dropped_chains = 0;  // open chains that could not be closed
  Length widest_gap;                // of the closed ones

  [[nodiscard]] bool any() const { return closed_chains != 0 || dropped_chains != 0; }
};

// The part cut halfway between `bottom` and `bottom + height`.
struct Slice {
  LayerIndex index = 0;
  Length bottom;  // above the bed
  Length height;  // the layer's thickness
  Region region;
  SliceDefects defects;

  [[nodiscard]] Length top() const { return bottom + height; }
};

// solid ∪ loose = slice.region, solid ∩ loose = ∅.
struct SplitLayer {
  Slice slice;
  Region solid;  // the wall: filled densely
  Region loose;  // the inside
};

}  // namespace core
