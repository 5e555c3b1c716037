// A road: one line of deposited material, with a width. Others call it line, bead, track or
// extrusion.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"              // Point
#include "core/regions/ring_corners.h"  // RingPlace
#include "core/units.h"                 // Length

namespace core {

enum class RoadKind {
  kSkirt,
  kOuterPerimeter,  // the part's visible surface
  kPerimeter,
  kSolid,    // dense fill of the wall
  kGapFill,  // of its own width, where whole roads don't fit
  kLoose,    // fill of the inside
  kBrim,
  kOverhangPerimeter,  // a perimeter that the layer below holds in part or not at all
  kTopSolid,           // dense fill under the open sky
  kBottomSolid,        // dense fill over nothing, but for bridges
  kBridge,             // straight roads from one held side to another, over air
  kInternalBridge,     // the same over the loose inside
  kIroning,            // smooths a top
  kRaft,               // under the part (raft.h)
  kSupport,            // holds what hangs (supports/support_roads.h)
  kSupportInterface,   // its dense layers
};

inline constexpr int kRoadKindCount = 16;

// How far the layer below holds a stretch of a road: the share of its width that lies over the
// slice below (overhangs.h). From kQuarter on, its centre line is in the air.
enum class Hold : std::uint8_t {
  kWhole,
  kThreeQuarters,  // or more
  kHalf,           // or more
  kQuarter,        // or more
  kLittle,         // less than a quarter, or nothing
};

// A turn of a spiral vase (vase_roads.h): it rises from the layer's bottom to its top.
struct SpiralTurn {
  Length below{};     // the height of the turn below; 0: a flat layer is below
  bool last = false;  // under a flat layer, or at the part's top

  [[nodiscard]] bool first() const { return below == Length(); }
};

// What belongs to none of several objects, such as the skirt.
inline constexpr int kNoObject = -1;

struct Road {
  RoadKind kind = RoadKind::kSolid;
  Length width;               // all along; where there are `widths`, about their mean
  bool closed = false;        // the last point joins the first, which is not repeated
  std::vector<Point> points;  // centre line; 2 points or more, 3 or more where closed

  // Empty, or one for each point: between two points the width changes linearly.
  std::vector<Length> widths{};

  // Empty: wholly held. Otherwise one for each point: of the stretch from it to the next one.
  std::vector<Hold> holds{};

  // Closed: the points at which it may start; empty: at any. Of no meaning once it is in order.
  std::vector<std::uint32_t> starts{};

  int layers = 1;  // as thick as so many layers (loose_blocks.h)

  std::optional<SpiralTurn> spiral{};  // closed, of one width

  int object = kNoObject;  // of several on the bed, which one it belongs to
};

[[nodiscard]] double length_mm(const Road& road);

[[nodiscard]] inline Length width_at(const Road& road, std::size_t point) {
  return road.widths.empty() ? road.width : road.widths[point];
}

[[nodiscard]] Length widest(const Road& road);

[[nodiscard]] inline Hold hold_from(const Road& road, std::size_t point) {
  return road.holds.empty() ? Hold::kWhole : road.holds[point];
}

// Whether its centre line is in the air all along.
[[nodiscard]] bool in_air(const Road& road);

// Turns the road round.
void reverse(Road& road);

// Makes a closed road start at its point `index`, or at a place, which becomes a point of it.
// ENSURES: road.starts is empty. REQUIRES: road.closed.
void start_at(Road& road, std::size_t index);
void start_at(Road& road, RingPlace place);

// A closed road cut open, its end clipped by `gap`; by a quarter of its length at most.
[[nodiscard]] Road opened(Road road, Length gap);

// Cross-section in mm² of a bead with round sides:  h (w − h) + π (h/2)²
//
//      ╭──────────╮
//      ╰──────────╯ h      w ≥ h; a narrower bead is taken as an ellipse, π w h / 4
//       ←── w ──→
[[nodiscard]] double bead_area_mm2(Length width, Length height);

// The width of a bead of this cross-section. REQUIRES: height > 0.
[[nodiscard]] Length bead_width(double area_mm2, Length height);

// That of a road of this kind. A bridge is round: nothing presses it flat.
[[nodiscard]] double road_area_mm2(RoadKind kind, Length width, Length height);

// What a road lays in all. Between two points its cross-section changes linearly.
[[nodiscard]] double volume_mm3(const Road& road, Length height);

// As what a stretch of a road is laid: a perimeter whose centre line is in the air is an overhang.
[[nodiscard]] RoadKind laid_as(RoadKind kind, Hold hold);

}  // namespace core
