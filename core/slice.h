// What passes between the stages: a slice, its offsets, and the layer split into wall and inside.
#pragma once

#include <cstdint>
#include <vector>

#include "core/offset_contours.h"  // OffsetContours
#include "core/region.h"           // Region
#include "core/units.h"            // LayerIndex, Length

namespace core {

// What was wrong with the mesh at one plane, and mended.
struct SliceDefects {
  std::int64_t closed_chains = 0;   // open chains closed across a gap
  std::int64_t dropped_chains = 0;  // open chains that could not be closed
  Length widest_gap;                // of the closed ones
  std::int64_t flipped_facets = 0;  // facets that turn against the rest of their contour
  std::int64_t doubled_facets = 0;  // facets cut along a line that another one has

  [[nodiscard]] bool any() const {
    return closed_chains != 0 || dropped_chains != 0 || flipped_facets != 0 || doubled_facets != 0;
  }
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

// What is cut from one slice's mountain, once, for all later stages.
struct SliceOffsets {
  Region wall_inner;                       // I(S): the inner offset at the wall's depth
  std::vector<OffsetContours> perimeters;  // centre lines of the perimeters, from the outside in
  std::vector<Region> perimeter_cores;     // where each perimeter has room (perimeters.h)
  Region interior;                         // what the perimeters leave to be filled
};

struct Layer {
  Slice slice;
  SliceOffsets offsets;
};

// solid ∪ loose = layer.slice.region, solid ∩ loose = ∅.
struct SplitLayer {
  Layer layer;
  Region solid;  // the wall: filled densely
  Region loose;  // the inside
};

}  // namespace core
