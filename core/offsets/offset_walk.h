// Polygon offset from a Voronoi diagram: walks along the Voronoi edges that cross a height. (The
// paper's walk, DETC2000/DAC-14285, "Our Offset Implementation".)
//
//        far from the contours      In a cell, walk from the crossing where its counter-clockwise
//      2 ._________. 1              border comes down (1) back along the border to the crossing
//       /           \               where it went up (2). Then step over that edge into the next
//      /  the cell   \              cell. Which vertices are far is decided once for all cells, so
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
