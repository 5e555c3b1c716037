#include "core/walls/corners_ahead.h"

#include <algorithm>
#include <utility>

#include "core/limits.h"  // kSeamLayersAheadMax

namespace core {

int seam_layers_ahead(const Settings& settings) {
  if (settings.seam != SeamPosition::kAligned) return 0;
  return std::min(wall_layers(settings), kSeamLayersAheadMax);
}

void CornersAhead::see(LayerIndex index, std::shared_ptr<const CornerIndex> corners) {
  if (layers_ == 0) return;
  if (seen_.empty()) first_ = index;
  seen_.push_back(std::move(corners));
}

std::optional<SplitLayer> CornersAhead::next() {
  if (waiting_.empty()) return std::nullopt;
  const LayerIndex index = waiting_.front().slice.index;
  const LayerIndex end = first_ + static_cast<LayerIndex>(seen_.size());
  if (layers_ > 0 && !ended_ && index + layers_ >= end) return std::nullopt;
  SplitLayer layer = std::move(waiting_.front());
  waiting_.pop_front();
  if (layers_ == 0) return layer;
  for (LayerIndex above = index + 1; above < std::min(end, index + 1 + layers_); ++above) {
    layer.corners_above.push_back(seen_[static_cast<std::size_t>(above - first_)]);
  }
  // Nobody asks for what is as low as this layer again.
  while (!seen_.empty() && first_ <= index) {
    seen_.pop_front();
    ++first_;
  }
  return layer;
}

}  // namespace core
