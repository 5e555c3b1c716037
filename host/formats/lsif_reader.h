// L-SIF, Layered SIF (UC Berkeley, 1999): what the paper's programs hand to one another.
//
//     (LSIF 1 0 (units mm) (desired_accuracy a) (thickness t) (offset o)
//       (layer (thickness t) (v 1 x y) … SET …) …)
//
//     SET:  (union SET …)   (intersection SET …)   (difference SET SET …)
//           (nested1d (contour …) (contour …) …)      the first holds the others, which are holes;
//           (contour 1 2 3 …)                         a nested1d within is an island again
//
// Booleans come unevaluated and are evaluated here, layer by layer. The grammar as it is public is
// cut off after the layer; the rest follows the format's words and the Berkeley writer:
//
//   - a layer has no height of its own: each lies on the one before, from 0; one of several solids
//     is written as several layers, which can't be told from several heights: it is taken as those;
//   - solid is what the structure says; the way round of a contour within nested1d is not used,
//     elsewhere what winds around at all is inside, as the Berkeley tools have it;
//   - sets that stand side by side in a layer are united: so are the wall and the inside;
//   - vertices stand in the layer or in the contour; colours, `offset`, `contours_offset` and what
//     is unknown are skipped, whole forms at a time.
#pragma once

#include <memory>

#include "core/result.h"                // Result
#include "host/files/input_file.h"      // InputFile
#include "host/formats/layer_reader.h"  // LayerReader

namespace host {

// COSTS: reads the head.
[[nodiscard]] core::Result<std::unique_ptr<LayerReader>> open_lsif(InputFile file);

}  // namespace host
