// Decides how high the layers of a mesh are, and checks that they can be printed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/result.h"                // Result
#include "core/settings.h"              // Settings
#include "core/slices/height_limits.h"  // HeightLimits
#include "core/slices/layer_heights.h"  // LayerHeights
#include "core/units.h"                 // Length
#include "host/part/opened_part.h"      // PartSummary

namespace host {

// Adds to the summary how many layers there are, the lowest one and the highest.
// REQUIRES: it has the part's height.
void summarise_heights(const core::LayerHeights& heights, PartSummary& summary);

// Of a part whose lowest point is at `lowest_z` and which is `height` high. `limits`: what its
// facets allow; nullopt: layers are not adaptive. Errors are those of check_layer_height()
// (layer_rules.h), for the first layer that has one; they start with `name`.
[[nodiscard]] core::Result<core::LayerHeights> part_heights(
    const core::Settings& settings, const std::optional<core::HeightLimits>& limits,
    std::int64_t lowest_z, core::Length height, const std::string& name);

}  // namespace host
