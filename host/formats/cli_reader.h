// Common Layer Interface 2.0, text and binary (cli_header.h, cli_geometry.h).
//
//     $$LAYER/z       upper face of the layer; the same z again goes on with the layer
//     $$POLYLINE/…    closed ones are the slice: what outer contours hold and inner ones do not;
//                     labels (parts) are united
//     open polylines and hatches are no part of it: counted, told, left out
//
// A layer reaches down to the one before. The first one, when empty, is the face that the second
// stands on; when not, it stands on 0 if it is at most kFirstLayersMax thicknesses of the second
// above it, and otherwise is as thick as the second.
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
