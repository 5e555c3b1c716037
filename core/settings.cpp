#include "core/settings.h"

#include <algorithm>
#include <cstdint>

namespace core {

int wall_layers(const Settings& settings) {
  const bool overridden = settings.wall_shape == WallShape::kCylinder && settings.wall_layers > 0;
  if (overridden) return settings.wall_layers;
  const std::int64_t w = settings.wall_thickness.units();
  const std::int64_t h = settings.layer_height.units();
  return static_cast<int>(std::max<std::int64_t>(1, (2 * w + h) / (2 * h)));
}

bool has_unequal_layers(const Settings& settings) {
  return settings.adaptive_layer_height || !settings.height_range.empty();
}

bool wall_counts_layers(const Settings& settings) {
  return settings.wall_shape == WallShape::kCylinder || settings.style == BuildStyle::kFast;
}

Settings first_layer_settings(Settings settings) {
  if (settings.first_layer_width > Length()) settings.road_width = settings.first_layer_width;
  return settings;
}

double bed_first_layer_celsius(const Settings& settings) {
  return settings.bed_first_layer_celsius < 0 ? settings.bed_celsius
                                              : settings.bed_first_layer_celsius;
}

}  // namespace core
