// Writes "Slice V0" contours (slice_v0_reader.h), in inches: outer contours clockwise, as in the
// one genuine file that could be measured; contours within them the other way, and so on.
//
//     slices   the part
//     walls    the wall's contours, then the inside's. Where the two meet, the contour stands in
//              the file twice, once for either side. Counted by nesting they cancel, so that such a
//              file is still the part.
//
// The format has no build styles: DETC2000/DAC-14285 gives the loose style to both copies of such a
// contour, because QuickSlice 6.2 mixes them up otherwise. Without styles that is: both copies
// stand among the inside's contours (LayerContents::kWallsForQuickSlice).
#pragma once

#include <memory>

#include "host/formats/layer_writer.h"  // LayerWriter, LayerFileHead

namespace host {

[[nodiscard]] std::unique_ptr<LayerWriter> slice_v0_writer(const LayerFileHead& head);

}  // namespace host
