// Adaptive layers of facets, by the default settings.
#pragma once

#include <vector>

#include "core/geometry.h"              // Triangle
#include "core/settings.h"              // Settings
#include "core/slices/height_limits.h"  // adaptive_limits
#include "core/slices/height_plan.h"    // adaptive_heights
#include "core/slices/layer_heights.h"  // LayerHeights
#include "core/units.h"                 // Length

namespace test {

inline core::Settings adaptive_settings() {
  core::Settings settings;
  settings.adaptive_layer_height = true;
  return settings;
}

// Of a part from 0 up to `top`. REQUIRES: settings that ask for adaptive layers.
inline core::LayerHeights adaptive_heights_of(const core::Settings& settings,
                                              const std::vector<core::Triangle>& facets,
                                              core::Length top) {
  core::HeightLimits limits = *core::adaptive_limits(settings);
  for (const core::Triangle& facet : facets) limits.add(facet);
  return core::adaptive_heights(settings, limits, 0, top);
}

}  // namespace test
