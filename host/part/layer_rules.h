// What a layer must keep to be printable with these settings, told before anything of it is sent.
#pragma once

#include <string>
#include <vector>

#include "core/result.h"        // Status
#include "core/roads/road.h"    // Road
#include "core/settings.h"      // Settings
#include "core/slices/slice.h"  // Slice

namespace host {

// Layers of a layer file have heights of their own: too low for the window's bound
// (kWallLayersMax), or too high for the road's width and the nozzle, is an error that names
// part, layer and height.
[[nodiscard]] core::Status check_layer_height(const std::string& part, const core::Slice& slice,
                                              const core::Settings& settings);

// Nothing where all beads lie on the bed; else what leaves it, and what to do.
[[nodiscard]] core::Status check_on_bed(const std::string& part, const core::Slice& slice,
                                        const std::vector<core::Road>& roads,
                                        const core::Settings& settings);

}  // namespace host
