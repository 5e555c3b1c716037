// Stacks of slices with ledges, islands and holes, and what tree supports make of them, all layers
// held at once.
#pragma once

#include <cstdint>
#include <vector>

#include "core/regions/region.h"         // Region
#include "core/settings.h"               // Settings
#include "core/supports/support_fold.h"  // SharedRegion, SupportLayer
#include "core/supports/tree_nodes.h"    // TreeNode

namespace test {

// A bed of 200 mm, and trees.
core::Settings tree_settings(core::SupportPlace place, double layer_height_mm = 0.2);

// Some blobs between 20 and 60 mm, others every few layers.
std::vector<core::Region> ledges(std::uint64_t seed, int layers);

// By layer, from 0.
std::vector<core::SharedRegion> avoided_in(const std::vector<core::Region>& slices,
                                           const core::Settings& settings);

struct TreeStack {
  std::vector<core::SupportLayer> layers;
  std::vector<std::vector<core::TreeNode>> nodes;
};
TreeStack trees_for(const std::vector<core::Region>& slices, const core::Settings& settings);

}  // namespace test
