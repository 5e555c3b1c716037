#include "core/walls/loose_blocks.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <utility>

#include "core/booleans/boolean.h"  // intersect
#include "core/walls/regularise.h"  // regularise_loose

namespace core {

namespace {

Length thickest_block(const Settings& settings) {
  return std::min(settings.nozzle_diameter, settings.road_width);
}

}  // namespace

int loose_block_layers(const Settings& settings) {
  if (settings.loose_pattern == LoosePattern::kLightning) return 1;  // branches differ by layer
  const std::int64_t fit = thickest_block(settings).units() / settings.layer_height.units();
  return static_cast<int>(std::clamp<std::int64_t>(fit, 1, settings.loose_every_layers));
}

void LooseBlocks::push(SplitLayer layer) {
  if (layers_ == 1 || (block_.empty() && layer.slice.index % layers_ != 0)) {
    ready_.push_back(std::move(layer));
    return;
  }
  block_.push_back(std::move(layer));
  if (block_.size() < static_cast<std::size_t>(layers_)) return;
  settle();
  release();
}

std::optional<SplitLayer> LooseBlocks::next() {
  if (ready_.empty()) return std::nullopt;
  SplitLayer layer = std::move(ready_.front());
  ready_.pop_front();
  return layer;
}

void LooseBlocks::settle() {
  Region region = common();
  if (region.empty()) return;
  const auto shared = std::make_shared<const Region>(std::move(region));
  const LayerIndex number = block_.front().slice.index / layers_;
  for (SplitLayer& layer : block_) layer.block = {shared, 0, number};
  block_.back().block.layers = layers_;
}

void LooseBlocks::release() {
  std::move(block_.begin(), block_.end(), std::back_inserter(ready_));
  block_.clear();
}

// What is loose in every layer of the block, within its perimeters.
Region LooseBlocks::common() const {
  const Length height = block_.front().slice.height;
  if (height * layers_ > thickest_block(settings_)) return {};  // a file's layers may be higher
  for (const SplitLayer& layer : block_) {
    if (layer.loose.empty() || layer.slice.height != height) return {};
  }
  Region region;
  for (std::size_t i = 0; i < block_.size(); ++i) {
    Region inside = intersect(style_.apply(block_[i]).loose, block_[i].offsets->interior);
    region = i == 0 ? std::move(inside) : intersect(region, inside);
    if (region.empty()) return {};
  }
  return regularise_loose(region, regularise_options(settings_));
}

}  // namespace core
