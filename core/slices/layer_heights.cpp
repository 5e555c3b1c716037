#include "core/slices/layer_heights.h"

#include <algorithm>
#include <utility>

#include "core/check.h"   // RIND_CHECK
#include "core/limits.h"  // kHeightBandsMax

namespace core {

LayerHeights::LayerHeights(Length first, Length rest)
    : LayerHeights(std::vector<HeightBand>{{0, Length(), first}, {1, first, rest}}) {}

LayerHeights::LayerHeights(std::vector<HeightBand> bands) {
  RIND_CHECK(!bands.empty() && bands.size() <= kHeightBandsMax);
  RIND_CHECK(bands[0].first == 0 && bands[0].bottom == Length());
  for (std::size_t i = 0; i < bands.size(); ++i) {
    RIND_CHECK(bands[i].height > Length());
    if (i == 0) continue;
    const HeightBand& below = bands[i - 1];
    const LayerIndex layers = bands[i].first - below.first;
    RIND_CHECK(layers > 0 && bands[i].bottom == below.bottom + below.height * layers);
  }
  bands_ = std::make_shared<const std::vector<HeightBand>>(std::move(bands));
}

const HeightBand& LayerHeights::band_of(LayerIndex layer) const {
  RIND_CHECK(layer >= 0);
  const auto next =
      std::upper_bound(bands_->begin(), bands_->end(), layer,
                       [](LayerIndex index, const HeightBand& b) { return index < b.first; });
  return *std::prev(next);
}

LayerIndex LayerHeights::count(Length top) const {
  // The bands whose first plane is not above the top.
  const auto next = std::upper_bound(
      bands_->begin(), bands_->end(), top,
      [](Length z, const HeightBand& b) { return z * 2 < b.bottom * 2 + b.height; });
  if (next == bands_->begin()) return 0;
  const HeightBand& band = *std::prev(next);
  const Length above = (top - band.bottom) * 2 - band.height;
  const LayerIndex layers = band.first + 1 + above.units() / (2 * band.height.units());
  return next == bands_->end() ? layers : std::min(layers, next->first);
}

}  // namespace core
