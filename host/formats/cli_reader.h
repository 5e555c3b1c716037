// Reads Common Layer Interface 2.0, text and binary (cli_header.h, cli_geometry.h).
//
//     $$LAYER/z       upper face of the layer; the same z again continues the layer
//     $$POLYLINE/…    closed ones make the slice: inside outer contours, outside inner ones; labels
//                     (parts) are united
//     open polylines and hatches are counted and left out, with a warning
//
// A layer's lower face is the upper face of the one before. If the first layer is empty, it gives
// the second's lower face. If not, it starts at 0 if its top is at most kFirstLayersMax thicknesses
// of the second layer above 0; otherwise it is as thick as the second.
#pragma once

#include <memory>

#include "core/result.h"                // Result
#include "host/files/input_file.h"      // InputFile
#include "host/formats/layer_reader.h"  // LayerReader

namespace host {

// First layers are often printed thicker.
inline constexpr int kFirstLayersMax = 3;

// COSTS: reads the file's head.
[[nodiscard]] core::Result<std::unique_ptr<LayerReader>> open_cli(InputFile file);

}  // namespace host
