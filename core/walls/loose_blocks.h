// Finds what of the inside can be laid once for several layers, in the highest of them, as thick as
// all of them (PrusaSlicer: infill_every_layers).
//
//     ▒▒▒▒▒▒██████████▒   a block of three layers: what is loose in all of them (█) is laid with
//       ▒▒▒▒██████████▒▒▒   the third layer, three layers thick; the rest of each layer's inside
//         ▒▒██████████▒▒▒▒   (▒) with that layer
//
// Blocks count from the bed, so that a print can start at any of them. A block is as many layers as
// are asked for, but no thicker than the nozzle's bore and a road's width. Layers of unequal height
// and the part's last ones have no block.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/settings.h"           // Settings
#include "core/walls/split_layer.h"  // SplitLayer
#include "core/walls/wall_style.h"   // WallStyle

namespace core {

// Layers of a block; 1: none is asked for, or layers are too thick.
[[nodiscard]] int loose_block_layers(const Settings& settings);

class LooseBlocks {
 public:
  // REQUIRES: with_style() was applied.
  explicit LooseBlocks(const Settings& settings)
      : settings_(settings), style_(settings), layers_(loose_block_layers(settings)) {}

  // The next layer up.
  void push(SplitLayer layer);
  // No layer follows.
  void end() { release(); }

  // The next layer whose block is known. COSTS: holds a block's layers; once a block, an
  // intersection for each layer, and what the style costs.
  [[nodiscard]] std::optional<SplitLayer> next();

 private:
  void settle();
  void release();
  [[nodiscard]] Region common() const;

  Settings settings_;
  WallStyle style_;
  int layers_;
  std::vector<SplitLayer> block_;
  std::deque<SplitLayer> ready_;
};

}  // namespace core
