// What an offset really is: straight pieces and circular arcs.
//
// Inside an offset, straight contour edges give straight pieces and reflex vertices give arcs about
// the vertex. They stay arcs here; flatten() makes a region of polygons where one is needed.
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

// Chords that stay within `tolerance` of the arcs. ENSURES: the region is clean.
[[nodiscard]] Region flatten(const OffsetContours& contours, Length tolerance);

}  // namespace core
