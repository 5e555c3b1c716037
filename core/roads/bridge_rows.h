// The rows of one bridge in one direction: straight roads from one held side to another.
//
//      held         air          held
//     ▒▒▒▒┌─────────────────────┐▒▒▒▒
//     ▒▒╶─┼─────────────────────┼─╴▒▒     a row starts and ends on what holds, an anchor deep
//     ▒▒╶─┼──────────┐  hole    │▒▒▒▒     or at a hole in the bridge, whose perimeter comes later
//     ▒▒▒▒└───────   └──────────┘▒▒▒▒     a row held at one end only is cut off: an overhang
//
// Neighbouring rows are joined at their ends where the join lies on what holds.
#pragma once

#include <vector>

#include "core/geometry.h"        // Point
#include "core/regions/region.h"  // Region
#include "core/roads/row_cuts.h"  // RowGrid, RowSpan
#include "core/units.h"           // Length
#include "core/vector.h"          // Vector

namespace core {

struct BridgeArea {
  Region region;  // to be covered: what is in the air, and anchors round it
  Region room;    // where centre lines may go; contains the region
  Region held;    // by the layer below
  Region holes;   // a row may end here
  Length anchor;  // of a row, on what holds it
};

// Those of the region's rings that may lie in the box.
[[nodiscard]] Region rings_near(const Region& region, const Box& box);

struct BridgeRow {
  std::size_t row = 0;  // of the grid
  RowSpan way;
  bool from_held = false;  // its start lies on what holds
  bool to_held = false;    // its end does
};

struct BridgeRows {
  RowGrid grid;
  std::vector<BridgeRow> rows;  // in ascending order of row, then along
  std::vector<BridgeRow> cut;   // stretches of rows that are not held on two sides
  double laid_spans_mm = 0;     // of `rows`: length in the air
  double laid_squares_mm2 = 0;  // of `rows`: sum of the squares of spans
  double cut_spans_mm = 0;      // of `cut`: length in the air
  double longest_cut_mm = 0;    // of them
  Point longest_cut_at;         // its middle
  double longest_mm = 0;        // span
  Point longest_at;             // its middle
};

// COSTS: O(points + crossings of rows and contours · log). REQUIRES: direction of length 1,
// distance > 0.
[[nodiscard]] BridgeRows bridge_rows(const BridgeArea& area, Vector direction, Length distance);

// What of the area the rows cover: without the strips of those that were cut off.
[[nodiscard]] Region covered_by(const BridgeRows& rows, const BridgeArea& area);

// The rows as lines: joined where they may be, each line of two points or more.
[[nodiscard]] std::vector<std::vector<Point>> joined(const BridgeRows& rows,
                                                     const BridgeArea& area);

}  // namespace core
