#include "core/supports/support_lookahead.h"

#include <algorithm>
#include <utility>

#include "core/booleans/boolean.h"          // intersect, subtract, unite
#include "core/booleans/simplified.h"       // simplified
#include "core/check.h"                     // RIND_CHECK
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/supports/support_regions.h"  // grown, kSupportTolerance, shared

namespace core {
namespace {

// Layers under a block that its lowest layer's supports depend on.
LayerIndex layers_below(const Settings& settings) {
  return settings.support_bottom_gap_layers + settings.support_bottom_interface_layers;
}

}  // namespace

SupportLookahead::SupportLookahead(const Settings& settings) : settings_(settings) {
  RIND_CHECK(settings.support_lookahead > 0);
}

void SupportLookahead::push(FoldSlice slice) {
  RIND_CHECK(!ended_);
  RIND_CHECK(slices_.empty() ? slice.index == 0 : slice.index == known() + 1);
  slices_.push_back(std::move(slice));
  if (known() + 1 >= block_ + 2 * LayerIndex{settings_.support_lookahead}) decide_block();
}

void SupportLookahead::end() {
  ended_ = true;
  if (!slices_.empty() && block_ <= known()) decide_block();
}

std::optional<SupportLayer> SupportLookahead::next() {
  if (decided_.empty()) return {};
  SupportLayer layer = std::move(decided_.front());
  decided_.pop_front();
  return layer;
}

std::optional<SupportLookahead::Cut> SupportLookahead::take_cut() {
  return std::exchange(told_, std::nullopt);
}

const FoldSlice* SupportLookahead::slice(LayerIndex index) const {
  if (slices_.empty() || index < slices_.front().index || index > known()) return nullptr;
  return &slices_[static_cast<std::size_t>(index - slices_.front().index)];
}

void SupportLookahead::decide_block() {
  Block block = folded();
  cut_ = false;
  if (block.below) find_cut(*block.below);
  for (SupportLayer& layer : block.layers) {
    laid_ = standing(layer);
    decided_.push_back(*laid_);
    wanted_ = std::move(layer);
  }
  block_ += static_cast<LayerIndex>(block.layers.size());
  while (slices_.front().index + layers_below(settings_) + 1 < block_) slices_.pop_front();
}

SupportLookahead::Block SupportLookahead::folded() {
  SupportFold fold(settings_);
  const LayerIndex last =
      ended_ ? known() : std::min(known(), block_ + settings_.support_lookahead - 1);
  fold.decide_from(last);
  Block block;
  const auto take = [&] {
    while (std::optional<SupportLayer> layer = fold.next()) {
      if (layer->index >= block_) {
        block.layers.push_front(*std::move(layer));
      } else if (layer->index == block_ - 1) {
        block.below = std::move(layer);
      } else {
        return;
      }
    }
  };
  for (std::size_t i = slices_.size(); i-- > 0;) {
    fold.push(slices_[i]);
    take();
  }
  if (slices_.front().index == 0) {
    fold.end();
    take();
  }
  RIND_CHECK(static_cast<LayerIndex>(block.layers.size()) == last - block_ + 1);
  return block;
}

// Pieces that are wide enough for a road.
bool SupportLookahead::is_missing(const Region& wanted, const Region& laid) const {
  const Region missing = subtract(wanted, laid);
  if (missing.empty()) return false;
  const Length half = Length::from_units(settings_.road_width_min.units() / 2);
  return !offset(missing, half, kSupportTolerance).empty();
}

void SupportLookahead::find_cut(const SupportLayer& wanted) {
  RIND_CHECK(laid_.has_value() && wanted_.has_value());
  cut_ = is_missing(*wanted.region, *laid_->region);
  if (!is_missing(*wanted.region, *wanted_->region)) return;
  const FoldSlice* at = slice(block_);
  RIND_CHECK(at != nullptr);
  told_ = Cut{block_, at->bottom, known()};
}

// All that supports may stand on in a layer, besides those of the layer below.
Region SupportLookahead::footing(LayerIndex index) const {
  Region all;
  if (const FoldSlice* under = slice(index - 1)) {
    all = grown(simplified(*under->region, kSupportTolerance), settings_.support_xy_distance);
  }
  if (const FoldSlice* under = slice(index - 1 - settings_.support_bottom_gap_layers)) {
    all = unite(all, *under->region);
  }
  return all;
}

SupportLayer SupportLookahead::standing(const SupportLayer& layer) {
  if (settings_.supports == SupportPlace::kBed) return columns_.standing(layer);
  if (!cut_) return layer;
  const Region under = unite(*laid_->region, footing(layer.index));
  return {layer.index, shared(intersect(*layer.region, under)),
          shared(intersect(*layer.interface, under))};
}

}  // namespace core
