// A road: one line of deposited material, with a width. Others call it line, bead, track or
// extrusion.
#pragma once

#include <vector>

#include "core/geometry.h"  // Point
#include "core/units.h"     // Length

namespace core {

enum class RoadKind {
  kSkirt,
  kOuterPerimeter,  // the part's visible surface
  kPerimeter,
  kSolid,    // dense fill of the wall
  kGapFill,  // of its own width, where whole roads don't fit
  kLoose,    // fill of the inside
};

inline constexpr int kRoadKindCount = 6;

struct Road {
  RoadKind kind = RoadKind::kSolid;
  Length width;
  bool closed = false;        // the last point joins the first, which is not repeated
  std::vector<Point> points;  // centre line; 2 points or more, 3 or more where closed
};

[[nodiscard]] double length_mm(const Road& road);

// Cross-section in mm² of a bead with round sides:  h (w − h) + π (h/2)²
//
//      ╭──────────╮
//      ╰──────────╯ h      w ≥ h; a narrower bead is taken as an ellipse, π w h / 4
//       ←── w ──→
[[nodiscard]] double bead_area_mm2(Length width, Length height);

}  // namespace core
