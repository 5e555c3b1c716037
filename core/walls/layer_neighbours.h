// Tells each layer the slices under it and over it. For that it keeps one layer back.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/regions/region.h"     // Region
#include "core/walls/split_layer.h"  // SplitLayer

namespace core {

class LayerNeighbours {
 public:
  // Takes the next layer up; returns the one under it, with its neighbours, if there is one.
  // COSTS: a copy of the slice and of what is loose, none where they equal those under it. Holds
  // three slices at most.
  [[nodiscard]] std::optional<SplitLayer> push(SplitLayer layer);

  // No layer follows: returns the last one. Nothing when there is none.
  [[nodiscard]] std::optional<SplitLayer> finish();

 private:
  std::optional<SplitLayer> last_;
  std::shared_ptr<const Region> slice_;  // of the last one
  std::shared_ptr<const Region> loose_;  // of the last one
  std::optional<std::int64_t> content_;  // of the last one (layer_offsets.h)
};

}  // namespace core
