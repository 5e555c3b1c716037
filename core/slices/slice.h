// The part cut at one height.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/geometry.h"              // Point
#include "core/regions/region.h"        // Region
#include "core/slices/changed_areas.h"  // ChangedAreas
#include "core/units.h"                 // LayerIndex, Length

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

// Where people have marked that supports are to hold what hangs of a slice, or are not to. Empty
// where nothing is marked.
struct SupportMarks {
  Region enforced;
  Region blocked;
};

// The part cut halfway between `bottom` and `bottom + height`.
struct Slice {
  LayerIndex index = 0;
  Length bottom;  // above the bed
  Length height;  // the layer's thickness
  Region region;
  SliceDefects defects;
  std::shared_ptr<const SupportMarks> marks{};  // null: none
  std::shared_ptr<const ChangedAreas> areas{};  // null: none

  [[nodiscard]] Length top() const { return bottom + height; }
};

}  // namespace core
