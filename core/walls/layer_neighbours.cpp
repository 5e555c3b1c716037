#include "core/walls/layer_neighbours.h"

#include <utility>

namespace core {

std::optional<SplitLayer> LayerNeighbours::push(SplitLayer layer) {
  layer.below = slice_;
  layer.below_loose = loose_;
  if (last_) layer.below_height = last_->slice.height;
  std::optional<std::int64_t> content;
  if (layer.offsets) content = layer.offsets->content;
  const bool equal = slice_ && content && content == content_;
  if (!equal) slice_ = std::make_shared<const Region>(layer.slice.region);
  if (!loose_ || *loose_ != layer.loose) loose_ = std::make_shared<const Region>(layer.loose);
  content_ = content;
  std::optional<SplitLayer> settled = std::exchange(last_, std::move(layer));
  if (settled) settled->above = slice_;
  return settled;
}

std::optional<SplitLayer> LayerNeighbours::finish() {
  slice_.reset();
  loose_.reset();
  return std::exchange(last_, std::nullopt);
}

}  // namespace core
