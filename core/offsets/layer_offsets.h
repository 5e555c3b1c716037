// What passes from the offsets to all later stages: a slice with the offsets that were cut from
// it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/offsets/offset_contours.h"  // OffsetContours
#include "core/offsets/slice_step.h"       // SliceStep
#include "core/regions/corner_index.h"     // CornerIndex
#include "core/regions/region.h"           // Region
#include "core/slices/slice.h"             // Slice
#include "core/units.h"                    // Length

namespace core {

// A slice's inner offset at one depth.
struct InnerOffset {
  Length depth;
  Region region;
};

// What is cut from one slice's mountain, once, for all later stages.
struct SliceOffsets {
  // Equal for equal slices that follow one another, and only for them (slice_offsets.h).
  std::int64_t content = 0;

  // From the slice whose content number is one less, if the wall is a ball; else nothing is known.
  SliceStep step{};

  // I(S) at the wall's depths, the deepest first: one where the wall is a cylinder. Where it is a
  // ball, one for each distance in layers (wall_depths.h) at which the slice is likely to matter.
  std::vector<InnerOffset> wall_inners;
  std::vector<OffsetContours> perimeters;  // centre lines of the perimeters, from the outside in
  Region wide_core;                        // what is deeper than in any narrow place
  Region interior;                         // what the perimeters leave to be filled
  std::shared_ptr<const CornerIndex> corners;  // the slice's own, where seams ask for them
};

struct Layer {
  Slice slice;
  std::shared_ptr<const SliceOffsets> offsets;  // shared by equal slices that follow one another
};

}  // namespace core
