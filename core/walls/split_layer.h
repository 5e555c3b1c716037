// What passes from the walls to the roads: a layer, split into its wall and its inside.
#pragma once

#include <memory>
#include <vector>

#include "core/offsets/layer_offsets.h"  // Layer
#include "core/regions/corner_index.h"   // CornerIndex
#include "core/regions/region.h"         // Region
#include "core/units.h"                  // LayerIndex
#include "core/walls/branch.h"           // Branches

namespace core {

// What is laid of the inside at once for several layers (loose_blocks.h).
struct LooseBlock {
  std::shared_ptr<const Region> region{};  // null: nothing
  int layers = 0;                          // in the layer where it is laid; 0 in the others
  LayerIndex number = 0;                   // of the block, from the bed
};

// solid ∪ loose = slice.region, solid ∩ loose = ∅. The neighbours are known after LayerNeighbours.
struct SplitLayer : Layer {
  Region solid;  // the wall, which slicers call shell: filled densely
  Region loose;  // the inside: filled sparsely (infill)

  // The slices under it and over it; null on the bed, and over the part's top.
  std::shared_ptr<const Region> below{}, above{};
  std::shared_ptr<const Region> below_loose{};  // what the window says is loose in the layer below
  Length below_height{};                        // of that layer

  // Supports in it, and those under its gap; null: none.
  std::shared_ptr<const Region> support{}, support_below{};

  // What the window says is loose, where some of it was made solid to hold a roof; null: nowhere.
  std::shared_ptr<const Region> window_loose{};

  LooseBlock block{};

  // What holds roofs over the inside, in this layer and in the one below; null: none.
  std::shared_ptr<const Branches> branches{}, below_branches{};

  // Of the slices above it, from the next one on: as many as CornersAhead knows. Null: none.
  std::vector<std::shared_ptr<const CornerIndex>> corners_above{};
};

}  // namespace core
