// Decides, layer by layer, which part must be a dense wall (shell) and which may be loose
// (infill).
//
// A point may be loose only where it is at least the wall's depth away from every contour of its
// own layer, of T layers above it and of T layers below it:
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
// Both are the same. Take a point p of S_n outside the paper's region. p is in no S_{n+i-1} −
// S_{n+i}, so by induction it is in every S_{n+i}, and in the same way in every S_{n-i}. p is in
// none of their offsets, so it is in every I(S_{n±i}). tests/core/walls/wall_splitter_test.cpp
// compares the two.
//
// That is a wall in the shape of a cylinder: one depth, T layers up and down. A ball (ball_wall.h)
// needs every layer of the window at a depth of its own. This class serves both.
//
// Keywords: shell, top and bottom layers, vertical shell thickness, infill region.
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
    std::int64_t layers_reused = 0;  // split as the layer before, without an operation
    std::int64_t offsets_cut = 0;    // not prepared: neighbours differ in height (ball_wall.h)
  };

  // A cylinder; wall_layers is T (settings.h). REQUIRES: 1 <= wall_layers <= kWallLayersMax.
  explicit WallSplitter(int wall_layers) : wall_(std::in_place_type<Cylinder>, wall_layers) {}

  // The shape that the settings ask for. REQUIRES: settings validated.
  explicit WallSplitter(const Settings& settings);

  // Starts in the middle of a part: what is below `first` is not known, and layers whose wall
  // reaches there are split as if the part ended below it. REQUIRES: nothing was pushed.
  void start_at(LayerIndex first);

  // Takes the next layer up, with its offsets (slice_offsets.h); returns a layer that this settles,
  // if any, offsets and all.
  //
  // COSTS: cylinder: at most ⌈log2(2T+1)⌉ <= kFoldCostMax intersections and one subtraction; ball:
  // 2T intersections. That bounds every call, not the mean: the printer is fed from here, and one
  // slow call leaves a blob of plastic.
  //
  // REQUIRES: layer.slice.index == next_index(); finish() was never called.
  // ENSURES: loose is bounded by the slice and by its own inner offset, to 2 units (boolean.h).
  [[nodiscard]] std::optional<SplitLayer> push(Layer layer);

  // A further layer that the last push() settled: there can be several where heights differ. Call
  // it until it returns nothing. COSTS: as push().
  [[nodiscard]] std::optional<SplitLayer> next();

  // Says that no layer follows; returns one of those still held, or nothing when all have left.
  [[nodiscard]] std::optional<SplitLayer> finish();

  // The index that push() takes next. Counts from 0, or start_at(), without gaps.
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
