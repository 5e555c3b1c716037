// The window of a ball-shaped wall (shell): which layers decide a layer's inside, and how deep.
//
//     loose(n) = ⋂ over the layers j near n of I_{d(n,j)}(S_j)       d(n,j): wall_depths.h
//
//     ┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄ j      near: within the wall's reach (wall_reach.h), counted in millimetres,
//        ╭─────╮  ↕z         so that layers may differ in height. The bed and the end of the part
//     ───│──n──│─────        count as outside: layers nearer to them than w are all solid.
//        ╰─────╯ w
//
// The cylinder's window (wall_fold.h) shares partial results between layers. A ball's can't, since
// every layer needs its neighbours at other depths: it takes up to 2T intersections a layer. Two
// shortcuts save most of them. A layer with the same operands as the layer before has the same
// result. And a slice adds nothing if contours move less, on the way to it, than its depth is
// smaller:
//
//     depth ▲                         Let C_j be what is not in S_j. If the result leaves out all
//     w ────┤─╮  ┆                    within r of C_{j-1}, and C_j reaches no deeper than e into
//           │ ┆╲ ┆╲  e                S_{j-1} (slice_step.h), then it leaves out all within r − e
//           │ ┆ ╲┆ ╲───  r            of C_j. If that is at least d(n,j), S_j adds nothing, and
//           │ ┆  ●   ●  d(n,j)        the next slice is asked with r − e. Otherwise S_j is an
//           └─┴──┴───┴──▶ j − n       operand, and r is d(n,j).
//
// So vertical walls cost nothing, whatever the layers' height; a slope of angle α from the vertical
// the layers within w · sin α, on one side where it only widens or only narrows; a step one layer.
// The result is what all operands give, to the arcs' tolerance.
//
// Not done: all operands in one sweep with counted winding numbers. Measured with Boost.Polygon,
// it took ten times as long, because every contour runs along all the others. Nor are operands cut
// out by boxes around the places where contours moved, and only what is outside of them there
// subtracted. That takes fewer operations, but they have more crossings: meshes took longer, and
// much longer with all in one sweep.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/limits.h"                 // kWindowLayersMax
#include "core/offsets/layer_offsets.h"  // Layer
#include "core/regions/region.h"         // Region
#include "core/ring_buffer.h"            // RingBuffer
#include "core/units.h"                  // Length
#include "core/walls/split_layer.h"      // SplitLayer
#include "core/walls/wall_reach.h"       // WallReach

namespace core {

class BallWall {
 public:
  // REQUIRES: wall_thickness > 0, arc_tolerance > 0.
  BallWall(Length wall_thickness, Length arc_tolerance);

  // REQUIRES: no layer is lower than w / kWallLayersMax; the layer lies on the last one; next() has
  // returned nothing since the last push().
  void push(Layer layer);

  // No layer follows.
  void finish() { finished_ = true; }

  // The next layer up that is settled, or nothing.
  // COSTS: at most kBallOperationsMax region operations.
  [[nodiscard]] std::optional<SplitLayer> next();

  [[nodiscard]] std::size_t layers_held() const { return window_.size(); }
  [[nodiscard]] std::size_t layers_held_peak() const { return layers_held_peak_; }
  // Region operations of the last next().
  [[nodiscard]] int operations() const { return operations_; }
  // Inner offsets that were not prepared and had to be made, because neighbours differ in height or
  // move more than the slice itself (slice_offsets.h).
  [[nodiscard]] std::int64_t offsets_cut() const { return offsets_cut_; }
  // Layers that were split as the one before, without an operation.
  [[nodiscard]] std::int64_t layers_reused() const { return layers_reused_; }

 private:
  // What an operand is: the same numbers mean the same region.
  struct Operand {
    std::int64_t content = 0;
    Length depth;
    std::size_t layer = 0;  // its number in the window
  };

  [[nodiscard]] std::vector<Operand> operands() const;
  [[nodiscard]] Length reach_between(std::size_t nearer, std::size_t farther) const;
  [[nodiscard]] Region intersection(const std::vector<Operand>& operands);
  void forget();

  Length wall_thickness_;
  WallReach reach_;
  Length arc_tolerance_;
  RingBuffer<Layer> window_{kWindowLayersMax};
  std::size_t pending_ = 0;  // the number in the window of the layer that is settled next
  bool finished_ = false;
  std::size_t layers_held_peak_ = 0;
  int operations_ = 0;
  std::int64_t offsets_cut_ = 0;
  std::int64_t layers_reused_ = 0;

  // The last split, for a layer that has the same operands.
  std::vector<std::pair<std::int64_t, Length>> last_operands_;
  Region last_solid_;
  Region last_loose_;
};

}  // namespace core
