#include "core/walls/wall_style.h"

#include <utility>

#include "core/booleans/boolean.h"          // subtract, subtract_within
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/walls/regularise.h"          // regularise_loose
#include "core/walls/spiral_vase.h"         // in_vase

namespace core {

Settings with_style(Settings settings) {
  if (settings.style == BuildStyle::kFast) settings.perimeters = kFastPerimeters;
  return settings;
}

SplitLayer WallStyle::apply(SplitLayer layer) const {
  if (in_vase(layer.slice, settings_)) return hollow(std::move(layer));
  if (settings_.spiral_vase) return dense(std::move(layer));  // its floor
  switch (settings_.style) {
    case BuildStyle::kThinWall:
      return regularised(std::move(layer));
    case BuildStyle::kRegular:
      return dense(std::move(layer));
    case BuildStyle::kFast:
      return fast(std::move(layer));
  }
  return layer;
}

SplitLayer WallStyle::regularised(SplitLayer layer) const {
  if (layer.loose.empty()) return layer;
  Region regular = regularise_loose(layer.loose, regularise_options(settings_));
  if (regular == layer.loose) return layer;
  layer.loose = std::move(regular);
  layer.solid = subtract_within(layer.slice.region, layer.loose);
  return layer;
}

SplitLayer WallStyle::dense(SplitLayer layer) {
  layer.solid = layer.slice.region;
  layer.loose = {};
  layer.below_loose.reset();
  return layer;
}

SplitLayer WallStyle::hollow(SplitLayer layer) const {
  layer.solid = vase_ring(layer.slice.region, settings_);
  layer.loose = subtract_within(layer.slice.region, layer.solid);
  layer.below_loose.reset();
  return layer;
}

// The window's depth is 0 here: its solid region is what some slice of the window does not cover.
SplitLayer WallStyle::fast(SplitLayer layer) const {
  layer.below_loose.reset();  // whether the layer below is hidden is not known here
  const Length half = Length::from_units(kHiddenSliverMax.units() / 2);
  const bool hidden =
      !layer.loose.empty() && offset(layer.solid, half, settings_.arc_tolerance).empty();
  const Region& slice = layer.slice.region;
  layer.loose = hidden ? layer.offsets->interior : Region();
  layer.solid = hidden ? subtract(slice, layer.loose) : slice;
  return layer;
}

}  // namespace core
