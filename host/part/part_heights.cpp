#include "host/part/part_heights.h"

#include <algorithm>

#include "core/slices/height_plan.h"  // adaptive_heights, layer_heights
#include "core/slices/slice.h"        // Slice
#include "host/part/layer_rules.h"    // check_layer_height

namespace host {

core::Result<core::LayerHeights> part_heights(const core::Settings& settings,
                                              const std::optional<core::HeightLimits>& limits,
                                              std::int64_t lowest_z, core::Length height,
                                              const std::string& name) {
  core::LayerHeights heights = limits ? core::adaptive_heights(settings, *limits, lowest_z, height)
                                      : core::layer_heights(settings);
  for (const core::HeightBand& band : heights.bands()) {
    const core::Slice slice{band.first, band.bottom, band.height, {}, {}};
    core::Status fits = check_layer_height(name, slice, settings);
    if (!fits.ok()) return fits.error();
  }
  return heights;
}

void summarise_heights(const core::LayerHeights& heights, PartSummary& summary) {
  summary.layers = heights.count(summary.height);
  summary.lowest_layer = summary.highest_layer = heights.height(0);
  for (const core::HeightBand& band : heights.bands()) {
    if (band.first >= summary.layers) break;
    summary.lowest_layer = std::min(summary.lowest_layer, band.height);
    summary.highest_layer = std::max(summary.highest_layer, band.height);
  }
}

}  // namespace host
