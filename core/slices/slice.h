// What passes between the stages: a slice, its offsets, and the layer split into wall and inside.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/geometry.h"                 // Point
#include "core/offsets/offset_contours.h"  // OffsetContours
#include "core/regions/region.h"           // Region
#include "core/units.h"                    // LayerIndex, Length

namespace core {

// What was wrong with the mesh at one plane, and mended.
struct SliceDefects {
  std::int64_t closed_chains = 0;    // open chains closed across a gap
  std::int64_t dropped_chains = 0;   // open chains that could not be closed
  std::int64_t wide_chains = 0;      // of the closed ones, across more than chain_gap_max
  Length widest_gap;                 // of the closed ones
  std::int64_t flipped_facets = 0;   // facets that turn against the rest of their contour
  std::int64_t doubled_facets = 0;   // facets cut along a line that another one has
  std::int64_t turned_contours = 0;  // contours that were inside out
  std::optional<Point> turned_at;    // a corner of the first of them

  [[nodiscard]] bool any() const {
    return closed_chains != 0 || dropped_chains != 0 || flipped_facets != 0 ||
           doubled_facets != 0 || turned_contours != 0;
  }
  void add(const SliceDefects& other);
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

// A slice's inner offset at one depth.
struct InnerOffset {
  Length depth;
  Region region;
};

// What is cut from one slice's mountain, once, for all later stages.
struct SliceOffsets {
  // Equal for equal slices that follow one another, and only for them (slice_offsets.h).
  std::int64_t content = 0;

  // I(S) at the wall's depths, the deepest first: one where the wall is a cylinder, one for each
  // distance in layers where it is a ball (wall_depths.h).
  std::vector<InnerOffset> wall_inners;
  std::vector<OffsetContours> perimeters;  // centre lines of the perimeters, from the outside in
  std::vector<Region> perimeter_cores;     // where each perimeter has room (perimeters.h)
  Region interior;                         // what the perimeters leave to be filled
};

struct Layer {
  Slice slice;
  std::shared_ptr<const SliceOffsets> offsets;  // shared by equal slices that follow one another
};

// solid ∪ loose = layer.slice.region, solid ∩ loose = ∅.
struct SplitLayer {
  Layer layer;
  Region solid;  // the wall: filled densely
  Region loose;  // the inside
};

}  // namespace core
