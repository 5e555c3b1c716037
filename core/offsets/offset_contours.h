// The exact shape of a polygon offset: straight pieces and circular arcs.
//
// Straight contour edges give straight pieces, and reflex corners give arcs around the corner.
// Arcs are kept; flatten() makes polygons of them where a region is needed.
#pragma once

#include <vector>

#include "core/geometry.h"        // Point
#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

// From its own `from` to the next piece's `from`.
struct OffsetPiece {
  enum class Kind { kLine, kArcCounterClockwise, kArcClockwise };
  Point from;
  Kind kind = Kind::kLine;
  Point centre{};  // of an arc
};

// Closed; outer contours run counter-clockwise, holes clockwise.
using OffsetContour = std::vector<OffsetPiece>;
using OffsetContours = std::vector<OffsetContour>;

// What stands for an arc: its chords, so that the error has one side everywhere; or, where lines
// touch it, fewer edges on both sides of it (arc_polygon.h), within 3 units of the lines.
enum class ArcForm { kChords, kBothSides };

// Polygons within `tolerance` of the arcs. ENSURES: the region is clean.
[[nodiscard]] Region flatten(const OffsetContours& contours, Length tolerance,
                             ArcForm form = ArcForm::kChords);

}  // namespace core
