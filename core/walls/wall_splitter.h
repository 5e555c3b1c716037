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
// is in every I(S_{n±i}). tests/core/walls/wall_splitter_test.cpp holds one against the other.
//
// That is the wall as a cylinder of the wall's depth, T layers up and down. A ball (ball_wall.h)
// wants every layer of the window at a depth of its own; both come out of this one door.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

#include "core/booleans/boolean.h"       // intersect
#include "core/limits.h"                 // kFoldCostMax
#include "core/offsets/layer_offsets.h"  // Layer
#include "core/regions/region.h"         // Region
#include "core/settings.h"               // Settings
#include "core/units.h"                  // LayerIndex
#include "core/walls/ball_wall.h"        // BallWall
#include "core/walls/split_layer.h"      // SplitLayer
#include "core/walls/wall_fold.h"        // WallFold

namespace core {

class WallSplitter {
 public:
  // What the window holds and costs, for the stats.
  struct Usage {
    std::size_t layers_held = 0;       // cylinder: at most T between calls, ball: 2T
    std::size_t layers_held_peak = 0;  // with the one being taken: T + 1, and 2T + 1
    std::size_t regions_held = 0;      // partial intersections: at most 2T; none for a ball
    std::size_t regions_held_peak = 0;
    int operations_last = 0;   // region operations of the last layer
    int operations_worst = 0;  // of any layer: at most kFoldCostMax + 1, ball: kBallOperationsMax
    std::int64_t operations = 0;     // of all layers
    std::int64_t layers_reused = 0;  // split as the layer before, for nothing
    std::int64_t offsets_cut = 0;    // anew, because neighbours differ in height (ball_wall.h)
  };

  // A cylinder; wall_layers is T (settings.h). REQUIRES: 1 <= wall_layers <= kWallLayersMax.
  explicit WallSplitter(int wall_layers) : wall_(std::in_place_type<Cylinder>, wall_layers) {}

  // The shape that the settings ask for. REQUIRES: settings validated.
  explicit WallSplitter(const Settings& settings);

  // Begins in the middle of a part: what is below `first` is not known, and layers whose wall
  // reaches there are split as if the part ended below it. REQUIRES: nothing was pushed.
  void begin_at(LayerIndex first);

  // Takes the next layer up, with its offsets (slice_offsets.h); returns a layer that this settles,
  // if any, offsets and all.
  //
  // COSTS: cylinder: at most ⌈log2(2T+1)⌉ <= kFoldCostMax intersections and one subtraction; ball:
  // 2T intersections. On any call: the link is fed from here, and a rare
  // slow one would be a blob of plastic, however good the mean.
  //
  // REQUIRES: layer.slice.index == next_index(); finish() was never called.
  // ENSURES: loose is bounded by the slice and by its own inner offset, to 2 units (boolean.h).
  [[nodiscard]] std::optional<SplitLayer> push(Layer layer);

  // A further layer that the last push() settled; more than one is only where heights differ.
  // To be called until it returns nothing. COSTS: as push().
  [[nodiscard]] std::optional<SplitLayer> next();

  // Says that no layer follows; returns one of those still held, or nothing when all have left.
  [[nodiscard]] std::optional<SplitLayer> finish();

  // The index that push() takes next. Counts from 0, or begin_at(), without gaps.
  [[nodiscard]] LayerIndex next_index() const { return next_index_; }

  [[nodiscard]] Usage usage() const;

 private:
  struct Intersect {
    Region operator()(const Region& a, const Region& b) const { return intersect(a, b); }
  };
  using Cylinder = WallFold<Layer, Region, Intersect>;

  [[nodiscard]] std::optional<SplitLayer> split(std::optional<Cylinder::Settled> settled);
  void count_operations(int operations);

  std::variant<Cylinder, BallWall> wall_;
  LayerIndex next_index_ = 0;
  int operations_last_ = 0;
  int operations_worst_ = 0;
  std::int64_t operations_ = 0;
};

}  // namespace core
