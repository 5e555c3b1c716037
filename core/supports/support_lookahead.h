// Supports of a part that is known only some layers up, from the bed up, in blocks of layers:
//
//     known      ░░░░░░░░░░░░░░░░░░░░░░
//                │   looked through   │   support_lookahead layers
//                ├────────────────────┤   from the top down (support_fold.h)
//                │  block: decided    │   support_lookahead layers
//     laid       ▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓
//
// A layer's supports hold what hangs at least support_lookahead layers above it, and no less than
// all of it where that ends lower. What would have to begin further down than that can't be laid
// any more: it is left out, and first_cut() tells where. What is laid is what a fold over the whole
// part finds, if nothing is left out.
//
// Where something is left out, supports stand on one another or on the part, and nowhere else:
//
//     V(n) = U(n) ∩ (V(n−1) ∪ slice(n − gap − 1) ∪ slice(n−1) grown by support_xy_distance)
#pragma once

#include <deque>
#include <optional>

#include "core/regions/region.h"         // Region
#include "core/settings.h"               // Settings
#include "core/supports/bed_columns.h"   // BedColumns
#include "core/supports/support_fold.h"  // FoldSlice, SupportLayer
#include "core/units.h"                  // LayerIndex, Length

namespace core {

class SupportLookahead {
 public:
  // What can't be laid any more.
  struct Cut {
    LayerIndex index = 0;  // the lowest layer where it is left out
    Length bottom;         // of that layer
    LayerIndex known = 0;  // the highest layer that was known then
  };

  // REQUIRES: settings in their ranges, support_lookahead > 0.
  explicit SupportLookahead(const Settings& settings);

  // The next slice up, the first one is layer 0. Equal slices that follow one another may share
  // their region. After each, take what next() has.
  // COSTS: as SupportFold::push, twice, when a block is decided. Holds the slices of two blocks,
  // and those of the gaps and interfaces below them.
  void push(FoldSlice slice);

  // No slice follows.
  void end();

  // The layers that are decided, from the bed up, each once.
  [[nodiscard]] std::optional<SupportLayer> next();

  // Each once, after the block where it was found.
  [[nodiscard]] std::optional<Cut> take_cut();

  // Slices in memory.
  [[nodiscard]] std::size_t held() const { return slices_.size(); }

 private:
  // The layers of a block, from the bed up; and the one below it, as it should have been.
  struct Block {
    std::deque<SupportLayer> layers;
    std::optional<SupportLayer> below;
  };

  [[nodiscard]] LayerIndex known() const { return slices_.back().index; }
  void decide_block();
  [[nodiscard]] Block folded();
  void find_cut(const SupportLayer& wanted);
  [[nodiscard]] bool is_missing(const Region& wanted, const Region& laid) const;
  [[nodiscard]] SupportLayer standing(const SupportLayer& layer);
  [[nodiscard]] Region footing(LayerIndex index) const;
  [[nodiscard]] const FoldSlice* slice(LayerIndex index) const;

  Settings settings_;
  std::deque<FoldSlice> slices_;  // from the bed up
  LayerIndex block_ = 0;          // the first layer that is not decided
  bool ended_ = false;
  bool cut_ = false;  // something is missing in the layer below
  std::optional<Cut> told_;
  BedColumns columns_;
  std::optional<SupportLayer> wanted_, laid_;  // in the layer below the block
  std::deque<SupportLayer> decided_;
};

}  // namespace core
