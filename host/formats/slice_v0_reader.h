// "Slice V0": the ASCII contours of Stratasys' FDM 1600 and its kin (.slc, .ssl).
//
//     Slice V0                   FILE(…UNITS(INCH)…)  SLICES()
//     Z <lower face> <thickness>   then for each contour "x y" lines and a C     … END
//
// Lengths are inches unless UNITS(MM) is said. Contours nest, whichever way they turn: files differ
// in that, and the format does not say. A layer stands on the one below; the heights may differ
// from that by rounding, not more than kSliceV0GapMax of a thickness.
//
// Not to be mixed up with QuickSlice 6's own .ssl, of which no description is public: refused.
#pragma once

#include <memory>

#include "core/result.h"                // Result
#include "host/files/input_file.h"      // InputFile
#include "host/formats/layer_reader.h"  // LayerReader

namespace host {

inline constexpr double kSliceV0GapMax = 0.1;

[[nodiscard]] core::Result<std::unique_ptr<LayerReader>> open_slice_v0(InputFile file);

}  // namespace host
