// Cuts all offsets of a slice that later stages need, at once: the wall's, the perimeters' centre
// lines, and the interior.
//
// With w the road's width and s the distance of neighbouring roads,
//
//     s = w − overlap · h (1 − π/4)       overlap 1: beads fill the layer without a void
//                                         overlap 0: beads touch, s = w
//     perimeter k (from 1): its centre line at depth  w/2 + (k − 1) s
//     interior: what is deeper than  w/2 + (P − ½) s,  left to be filled
//
//     slice's edge │←w/2→┆←── s ──→┆← s/2→│ interior
//                       1st       2nd
//
// Keywords: inset, extrusion spacing, perimeter.
#pragma once

#include <cstdint>
#include <memory>

#include "core/offsets/layer_offsets.h"  // SliceOffsets
#include "core/regions/region.h"         // Region
#include "core/settings.h"               // Settings
#include "core/slices/slice.h"           // Slice
#include "core/units.h"                  // Length

namespace core {

// Distance of neighbouring roads of the user's width. The formula is above.
[[nodiscard]] Length perimeter_spacing(const Settings& settings, Length layer_height);

// Depth of the centre line of perimeter `number`, counted from 1.
[[nodiscard]] Length perimeter_depth(const Settings& settings, Length layer_height, int number);

// The largest disc in a place that holds the perimeters of both sides and one road more between
// them. Narrower places have roads of their own widths (roads/beading.h).
[[nodiscard]] Length wide_depth(const Settings& settings, Length layer_height);

// Depth below the wall's edge at which its rows end, as a share of their distance (wall_fill.h).
// A share of one half would lay exactly what joined rows need, but leave notches between two joins.
inline constexpr double kRowEndShare = 0.05;

// Cuts slice after slice. A slice that equals the one before it, point by point, shares its
// offsets, so that a prismatic part is cut once.
//
//     slices in order ──> reserve() ──┬── new offsets ──> fill() in any thread ──┐
//                                     └── those of the slice before ─────────────┴──> offsets
class OffsetCutter {
 public:
  struct Reservation {
    std::shared_ptr<SliceOffsets> offsets;  // never null; shared with an equal slice
    bool to_fill = false;                   // this caller has to call fill(), nobody else does
  };

  // REQUIRES: settings in their ranges.
  explicit OffsetCutter(const Settings& settings)
      : settings_(settings), first_settings_(first_layer_settings(settings)) {}

  // COSTS: a comparison; for a ball's wall also as slice_step().
  [[nodiscard]] Reservation reserve(const Slice& slice);

  // Returns how many depths needed more than one try. Each thread keeps its scratch memory.
  // COSTS: one polygon offset at all depths: the wall's (wall_depths.h), the perimeters',
  // the interior's, that of wide places. REQUIRES: offsets that were reserved for this slice.
  [[nodiscard]] std::int64_t fill(const Slice& slice, SliceOffsets& offsets) const;

  // Both at once.
  [[nodiscard]] std::shared_ptr<const SliceOffsets> cut(const Slice& slice);

  // Slices that equalled the one before.
  [[nodiscard]] std::int64_t reused() const { return reused_; }

 private:
  Settings settings_;
  Settings first_settings_;  // of the first layer
  Region last_region_;
  Length last_height_;
  Length last_width_;  // of its roads
  std::shared_ptr<SliceOffsets> last_;
  std::int64_t reused_ = 0;
};

}  // namespace core
