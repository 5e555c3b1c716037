// The paper's walk ("Our Offset Implementation"): along the Voronoi edges that cross a height.
//
//        far from the contours      Within a cell the offset runs from the crossing where its
//      2 ._________. 1              counter-clockwise border comes down (1), back along the border,
//       /           \               to the one where it went up (2); then over that edge into the
//      /  the cell   \              next cell. Which vertices are far is decided once for all, so
//     o———— site —————o             every walk closes.
//
// Crossing points are computed from the two sites (parallel lines, circles), not from vertices.
#pragma once

#include <optional>

#include "core/offsets/offset_contours.h"  // OffsetContours
#include "core/offsets/voronoi_diagram.h"  // VoronoiDiagram
#include "core/units.h"                    // Length

namespace core {

// nullopt: a crossing point was further than it may be from its sites' offsets, so the diagram is
// not to be believed after all. REQUIRES: depth is not 0.
[[nodiscard]] std::optional<OffsetContours> walk_offset(const VoronoiDiagram& diagram,
                                                        Length depth);

}  // namespace core
