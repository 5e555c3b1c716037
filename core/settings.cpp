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

bool wall_counts_layers(const Settings& settings) {
  return settings.wall_shape == WallShape::kCylinder || settings.style == BuildStyle::kFast;
}

}  // namespace core
