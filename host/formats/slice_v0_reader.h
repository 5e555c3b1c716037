// Reads "Slice V0", the ASCII contours of Stratasys' FDM 1600 and similar machines (.slc, .ssl).
//
//     Slice V0                   FILE(…UNITS(INCH)…)  SLICES()
//     Z <lower face> <thickness>   then for each contour "x y" lines and a C     … END
//
// Lengths are in inches unless UNITS(MM) is given. Contours count by nesting, not by orientation:
// files differ in that, and the format does not define it. Each layer lies on the one below; by
// rounding, heights may differ by up to kSliceV0GapMax of a thickness.
//
// QuickSlice 6 has a .ssl format of its own without a public description, which is refused.
#pragma once

#include <memory>

#include "core/result.h"                // Result
#include "host/files/input_file.h"      // InputFile
#include "host/formats/layer_reader.h"  // LayerReader

namespace host {

inline constexpr double kSliceV0GapMax = 0.1;

[[nodiscard]] core::Result<std::unique_ptr<LayerReader>> open_slice_v0(InputFile file);

}  // namespace host
