// The slices of a spiral vase (core/walls/spiral_vase.h): above its floor, the largest contour.
#pragma once

#include <memory>
#include <string>

#include "core/settings.h"              // Settings
#include "host/formats/layer_source.h"  // LayerSource
#include "host/system/warning_box.h"    // WarningBox

namespace host {

// The layers as a vase of the settings needs them; the same ones if there is none. The first slice
// that loses a contour is a warning, in which `part` names the file. `warnings` outlives the
// source.
[[nodiscard]] std::unique_ptr<LayerSource> vase_layers(std::unique_ptr<LayerSource> layers,
                                                       const core::Settings& settings,
                                                       const std::string& part,
                                                       WarningBox& warnings);

}  // namespace host
