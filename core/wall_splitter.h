// Decides, layer by layer, which part must be a dense wall and which may be loose.
//
// A spot may be loose only where the part goes on for T layers above it and T below it, at least
// the wall's depth away from every contour:
//
//     loose(n) = I(S_{n-T}) ∩ … ∩ I(S_{n+T})          solid(n) = S_n − loose(n)
//
//        ▓▓▓▓▓▓▓▓                 S_n  the slice, I(S) its inner offset at the wall's depth,
//       ▓▓▓▓▓▓▓▓▓▓      ▓ solid        ∅ outside the part: the first and the last T layers
//      ▓▓▓░░░░░░▓▓▓     ░ loose        are all solid
//     ▓▓▓░░░░░░░░▓▓▓
//     ▓▓▓▓▓▓▓▓▓▓▓▓▓▓
//
// The paper (DETC2000/DAC-14285, "The extended regions") unites 6T pieces instead:
//
//     Offset(S_n) ∪ S_n ∩ ⋃_{i=1..T} [(S_{n+i-1} − S_{n+i}) ∪ (S_{n-i+1} − S_{n-i})
//                                      ∪ Offset(S_{n+i}) ∪ Offset(S_{n-i})],   Offset(S) = S − I(S)
//
// Both say the same. Take p in S_n outside the paper's region: p is in no S_{n+i-1} − S_{n+i}, so
// by induction p is in every S_{n+i}, and likewise downwards; p is in none of their offsets, so it
// is in every I(S_{n±i}). tests/core/wall_splitter_test.cpp holds one against the other.
#pragma once

#include <cstddef>
#include <optional>

#include "core/boolean.h"    // intersect
#include "core/limits.h"     // kFoldCostMax
#include "core/region.h"     // Region
#include "core/slice.h"      // Layer, SplitLayer
#include "core/units.h"      // LayerIndex
#include "core/wall_fold.h"  // WallFold

namespace core {

class WallSplitter {
 public:
  // What the window holds and costs, for the stats.
  struct Usage {
    std::size_t layers_held = 0;       // between calls: at most T
    std::size_t layers_held_peak = 0;  // with the one being taken: at most T + 1
    std::size_t regions_held = 0;      // partial intersections: at most 2T
    std::size_t regions_held_peak = 0;
    int operations_last = 0;   // region operations of the last push
    int operations_worst = 0;  // of any push so far: at most kFoldCostMax + 1
  };

  // wall_layers is T (settings.h). REQUIRES: 1 <= wall_layers <= kWallLayersMax.
  explicit WallSplitter(int wall_layers) : window_(wall_layers) {}

  // Takes the next layer up, with I(S) in offsets.wall_inner; returns the layer that this settles,
  // if any, offsets and all.
  //
  // COSTS: at most ⌈log2(2T+1)⌉ <= kFoldCostMax intersections and one subtraction, on any call.
  // The link is fed from here: a rare slow call would be a blob of plastic, however good the mean.
  //
  // REQUIRES: layer.slice.index == next_index(), and finish() was never called.
  // ENSURES: loose is bounded by the slice and by its own inner offset, to 2 units (boolean.h).
  [[nodiscard]] std::optional<SplitLayer> push(Layer layer);

  // Says that no layer follows; returns one of those still held, all solid, or nothing when all
  // have left.
  [[nodiscard]] std::optional<SplitLayer> finish();

  // The index that push() takes next. Counts from 0, without gaps.
  [[nodiscard]] LayerIndex next_index() const { return window_.pushed(); }

  [[nodiscard]] Usage usage() const;

 private:
  struct Intersect {
    Region operator()(const Region& a, const Region& b) const { return intersect(a, b); }
  };
  using Window = WallFold<Layer, Region, Intersect>;

  [[nodiscard]] std::optional<SplitLayer> split(std::optional<Window::Settled> settled);

  Window window_;
  int operations_last_ = 0;
  int operations_worst_ = 0;
};

}  // namespace core
