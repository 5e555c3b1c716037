// Checks that a layer is printable with these settings, before any of it is sent.
#pragma once

#include <string>
#include <vector>

#include "core/result.h"        // Error, Status
#include "core/roads/road.h"    // Road
#include "core/settings.h"      // Settings
#include "core/slices/slice.h"  // Slice

namespace host {

// For layers with heights of their own. Error if the height is too small for the window's bound
// (kWallLayersMax), or too large for the road's width or the nozzle; it names part, layer and
// height.
[[nodiscard]] core::Status check_layer_height(const std::string& part, const core::Slice& slice,
                                              const core::Settings& settings);

// Nothing of the part is as wide as a road.
[[nodiscard]] core::Error no_road_fits(const std::string& part, const core::Settings& settings);

// Error if a bead leaves the bed; it says which, and what to do.
[[nodiscard]] core::Status check_on_bed(const std::string& part, const core::Slice& slice,
                                        const std::vector<core::Road>& roads,
                                        const core::Settings& settings);

}  // namespace host
