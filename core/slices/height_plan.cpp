#include "core/slices/height_plan.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/check.h"                  // RIND_CHECK
#include "core/limits.h"                 // kHeightBandsMax
#include "core/slices/height_ceiling.h"  // HeightCeiling
#include "core/slices/height_ranges.h"   // height_ranges, HeightRange

namespace core {
namespace {

constexpr Length kUnit = Length::from_units(1);

std::vector<HeightRange> ranges_of(const Settings& settings) {
  Result<std::vector<HeightRange>> ranges = height_ranges(settings);
  RIND_CHECK(ranges.ok());
  return std::move(ranges).value();
}

// Walks upwards, layer by layer or, where the ceiling is level, over many at once.
class HeightWalk {
 public:
  // Layers between ranges are whole steps high, and at least `lowest`.
  HeightWalk(const HeightCeiling& ceiling, Length step, Length lowest)
      : ceiling_(ceiling), step_(step), lowest_(lowest) {}

  void add(Length height, LayerIndex layers) {
    if (bands_.empty() || bands_.back().height != height) {
      bands_.push_back({next_, bottom_, height});
    }
    bottom_ += height * layers;
    next_ += layers;
  }

  // Layers up to `top` or a little above.
  void fill_beyond(Length top) {
    while (bottom_ < top && fits()) {
      const Length height = greatest();
      const Length level = std::min(ceiling_.level_until(bottom_), top);
      add(height, std::max<LayerIndex>(1, (level - bottom_).units() / height.units()));
    }
  }

  // Layers that end exactly there.
  void fill_up_to(Length end) {
    while (bottom_ < end && fits()) {
      const Length height = greatest(), rest = end - bottom_;
      if (height >= rest) return add(rest, 1);
      // So many may come before the rest is too low for one.
      const LayerIndex whole = (rest - lowest_).units() / height.units();
      if (whole == 0) return split(rest);
      const Length level = ceiling_.level_until(bottom_);
      const LayerIndex alike = std::min(level - bottom_, rest).units() / height.units();
      add(height, std::clamp<LayerIndex>(alike, 1, whole));
    }
  }

  [[nodiscard]] bool fits() const { return bands_.size() <= kHeightBandsMax; }
  [[nodiscard]] std::vector<HeightBand> take() { return std::move(bands_); }

 private:
  // Of a layer that starts here.
  [[nodiscard]] Length greatest() const {
    const std::int64_t steps = ceiling_.at(bottom_).units() / step_.units();
    Length height = std::max(lowest_, step_ * steps);
    while (height > lowest_ && ceiling_.least(bottom_, bottom_ + height) < height) height -= step_;
    return height;
  }

  // Into equal layers, but for a unit, as few as the ceiling allows: two, or three.
  void split(Length rest) {
    const Length least = ceiling_.least(bottom_, bottom_ + rest);
    const LayerIndex layers = rest > least * 2 ? 3 : 2;
    const Length height = Length::from_units(rest.units() / layers);
    const LayerIndex higher = rest.units() % layers;
    if (higher > 0) add(height + kUnit, higher);
    add(height, layers - higher);
  }

  const HeightCeiling& ceiling_;
  Length step_;
  Length lowest_;
  std::vector<HeightBand> bands_;
  LayerIndex next_ = 0;
  Length bottom_;  // of that layer
};

}  // namespace

LayerHeights layer_heights(const Settings& settings) {
  const HeightCeiling ceiling(settings.layer_height);
  HeightWalk walk(ceiling, kUnit, settings.layer_height);
  walk.add(first_layer_height(settings), 1);
  for (const HeightRange& range : ranges_of(settings)) {
    walk.fill_up_to(range.from);
    walk.add(range.height, range.layers());
  }
  walk.add(settings.layer_height, 1);
  return LayerHeights(walk.take());
}

LayerHeights adaptive_heights(const Settings& settings, HeightLimits limits, std::int64_t bed_z,
                              Length top) {
  std::vector<HeightRange> ranges = ranges_of(settings);
  std::erase_if(ranges, [&](const HeightRange& range) { return range.from >= top; });
  for (const HeightRange& range : ranges) {
    limits.limit(bed_z + range.from.units(), bed_z + range.end().units(), range.height);
  }
  while (true) {
    const HeightCeiling ceiling(limits, bed_z);
    HeightWalk walk(ceiling, kHeightStep, limits.bounds().lowest);
    walk.add(first_layer_height(settings), 1);
    for (const HeightRange& range : ranges) {
      walk.fill_up_to(range.from);
      walk.add(range.height, range.layers());
    }
    walk.fill_beyond(top);
    if (walk.fits()) return LayerHeights(walk.take());
    limits.widen();
  }
}

}  // namespace core
