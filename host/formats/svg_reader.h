// Reads SVG with layers, as Slic3r writes it. There are two variants, without a specification:
//
//     <g id="layer0" slic3r:z="…">
//       polygons   <polygon slic3r:type="contour" points="x,y x,y …"> and "hole"
//                  z is the middle of the layer, and too small by 10^6 in Slic3r 1.3
//       paths      <path d="M x y x y … z M …">, an island with its holes (even-odd); y counts
//                  down from the picture's height; slic3r:z is the layer's top, and
//                  slic3r:layer-height its thickness
//
// All in mm. A layer without a thickness starts at the top of the layer before and reaches as far
// above its middle as below it. Layers may have gaps of kSvgGapMax of a thickness, by rounding.
#pragma once

#include <memory>

#include "core/result.h"                // Result
#include "host/files/input_file.h"      // InputFile
#include "host/formats/layer_reader.h"  // LayerReader

namespace host {

inline constexpr double kSvgGapMax = 0.1;
// If the first layer is lower than this, heights are too small by 10^6.
inline constexpr double kSvgLowestMm = 1e-3;

[[nodiscard]] core::Result<std::unique_ptr<LayerReader>> open_svg(InputFile file);

}  // namespace host
