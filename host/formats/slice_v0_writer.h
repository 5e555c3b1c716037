// Writes "Slice V0" contours (slice_v0_reader.h), in inches. Outer contours are clockwise, as in
// the only genuine file that could be measured; contours within them alternate.
//
//     slices   the part
//     walls    the wall's contours, then the inside's. Where the two meet, the contour is in the
//              file twice, once for each side. The two copies cancel by nesting, so such a file
//              still describes the part.
//
// In DETC2000/DAC-14285 both copies of such a contour have the loose build style, because
// QuickSlice 6.2 confuses them otherwise. This format has no build styles; the equivalent is to
// write both copies among the inside's contours (LayerContents::kWallsForQuickSlice).
#pragma once

#include <memory>

#include "host/formats/layer_writer.h"  // LayerWriter, LayerFileHead

namespace host {

[[nodiscard]] std::unique_ptr<LayerWriter> slice_v0_writer(const LayerFileHead& head);

}  // namespace host
