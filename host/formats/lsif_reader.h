// Reads L-SIF, Layered SIF (UC Berkeley, 1999), in which the paper's programs exchange layers.
//
//     (LSIF 1 0 (units mm) (desired_accuracy a) (thickness t) (offset o)
//       (layer (thickness t) (v 1 x y) … SET …) …)
//
//     SET:  (union SET …)   (intersection SET …)   (difference SET SET …)
//           (nested1d (contour …) (contour …) …)      the first is the outer contour, the others
//           (contour 1 2 3 …)                         are holes; a nested1d within is an island
//
// Booleans in the file are evaluated here, layer by layer. The published grammar is cut off after
// the layer; the rest follows the format's words and the Berkeley writer:
//
//   - Layers have no heights: each lies on the one before, from 0. A layer of several solids is
//     written as several layers, which look like several heights and are read as such.
//   - Within nested1d, the structure decides what is solid; the orientation of contours is ignored.
//     Elsewhere the non-zero rule decides, as in the Berkeley tools.
//   - Sets side by side in a layer are united; wall and inside are such sets.
//   - Vertices are in the layer or in the contour. Colours, `offset`, `contours_offset` and unknown
//     forms are skipped.
#pragma once

#include <memory>

#include "core/result.h"                // Result
#include "host/files/input_file.h"      // InputFile
#include "host/formats/layer_reader.h"  // LayerReader

namespace host {

// COSTS: reads the head.
[[nodiscard]] core::Result<std::unique_ptr<LayerReader>> open_lsif(InputFile file);

}  // namespace host
