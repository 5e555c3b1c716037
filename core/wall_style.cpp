#include "core/wall_style.h"

#include <utility>

#include "core/boolean.h"           // subtract, subtract_within
#include "core/regularise.h"        // regularise_loose
#include "core/voronoi_mountain.h"  // offset

namespace core {

Settings with_style(Settings settings) {
  if (settings.style == BuildStyle::kFast) settings.perimeters = kFastPerimeters;
  return settings;
}

SplitLayer WallStyle::apply(SplitLayer layer) {
  switch (settings_.style) {
    case BuildStyle::kThinWall:
      return regularised(std::move(layer));
    case BuildStyle::kRegular:
      layer.solid = layer.layer.slice.region;
      layer.loose = {};
      return layer;
    case BuildStyle::kFast:
      return fast(std::move(layer));
  }
  return layer;
}

SplitLayer WallStyle::regularised(SplitLayer layer) {
  if (layer.loose.empty()) return layer;
  if (layer.solid != last_solid_ || layer.loose != last_loose_) {
    last_regular_loose_ =
        regularise_loose(layer.loose, {.width_min = settings_.loose_width_min,
                                       .area_min_mm2 = settings_.loose_area_min_mm2,
                                       .arc_tolerance = settings_.arc_tolerance});
    last_regular_solid_ = last_regular_loose_ == layer.loose
                              ? layer.solid
                              : subtract_within(layer.layer.slice.region, last_regular_loose_);
    last_solid_ = std::move(layer.solid);
    last_loose_ = std::move(layer.loose);
  }
  regularised_mm3_ +=
      (last_loose_.area_mm2() - last_regular_loose_.area_mm2()) * layer.layer.slice.height.mm();
  layer.solid = last_regular_solid_;
  layer.loose = last_regular_loose_;
  return layer;
}

// The window's depth is 0 here: its solid region is what some slice of the window does not cover.
SplitLayer WallStyle::fast(SplitLayer layer) const {
  const Length half = Length::from_units(kHiddenSliverMax.units() / 2);
  const bool hidden =
      !layer.loose.empty() && offset(layer.solid, half, settings_.arc_tolerance).empty();
  const Region& slice = layer.layer.slice.region;
  layer.loose = hidden ? layer.layer.offsets->interior : Region();
  layer.solid = hidden ? subtract(slice, layer.loose) : slice;
  return layer;
}

}  // namespace core
