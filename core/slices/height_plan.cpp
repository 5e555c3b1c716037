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
  // Layers between ranges are whole steps high, and at least `lowest`. `flats`: heights, in order,
  // at which one of them should end.
  HeightWalk(const HeightCeiling& ceiling, Length step, Length lowest, std::vector<Length> flats)
      : ceiling_(ceiling), step_(step), lowest_(lowest), flats_(std::move(flats)) {}

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
      if (add_to_flat(height, top)) continue;
      add(height, std::max<LayerIndex>(1, alike(height, top)));
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
      if (add_to_flat(height, end - lowest_)) continue;
      add(height, std::clamp<LayerIndex>(alike(height, end), 1, whole));
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

  // How many layers of that height may follow one another, up to the next flat face's last ones.
  [[nodiscard]] LayerIndex alike(Length height, Length end) const {
    Length level = std::min(ceiling_.level_until(bottom_), end);
    if (next_flat_ < flats_.size()) {
      level = std::min(level, flats_[next_flat_] - height * (kLayersToFlat - 1));
    }
    return (level - bottom_).units() / height.units();
  }

  // In whole steps, to the nearest.
  [[nodiscard]] Length way_to(Length flat) const {
    return step_ * (((flat - bottom_).units() + step_.units() / 2) / step_.units());
  }

  // One of the last layers below the next flat face; false if that is farther, above `end`, or
  // can't be reached by layers that are at most so high.
  bool add_to_flat(Length height, Length end) {
    while (next_flat_ < flats_.size()) {
      const Length flat = flats_[next_flat_], way = way_to(flat);
      if (flat > end || way > height * kLayersToFlat) return false;
      const LayerIndex layers = (way.units() + height.units() - 1) / height.units();
      // Equal ones, but for a step: the higher ones first.
      const std::int64_t steps = way.units() / step_.units();
      if (layers > 0 && steps / layers * step_.units() >= lowest_.units()) {
        add(step_ * ((steps + layers - 1) / layers), 1);
        return true;
      }
      ++next_flat_;
    }
    return false;
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
  std::vector<Length> flats_;
  std::size_t next_flat_ = 0;  // that is above the bottom
};

}  // namespace

LayerHeights layer_heights(const Settings& settings) {
  const HeightCeiling ceiling(settings.layer_height);
  HeightWalk walk(ceiling, kUnit, settings.layer_height, {});
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
    limits.limit(bed_z + range.from.units(), bed_z + std::min(range.end(), top).units(),
                 range.height);
  }
  while (true) {
    const HeightCeiling ceiling(limits, bed_z);
    std::vector<Length> flats;
    for (const std::int64_t z : limits.flats().heights()) {
      flats.push_back(Length::from_units(z - bed_z));
    }
    HeightWalk walk(ceiling, kHeightStep, limits.bounds().lowest, std::move(flats));
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
