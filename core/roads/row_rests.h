// What the rows of a fill leave of a region: piece ∩ strip outside the row's ends.
//
//       ╲▒▒┌──────────────────┐▒│     Row n is taken to cover its strip, a row's distance broad,
//        ╲▒│- - - - row - - - │▒│     from end to end and `reach` beyond. Between two rows of a
//         ╲└──────────────────┘▒│     strip, and outside them, is a window: what the region has in
//                                     it is the rest there.
//
// A window's area is known in closed form: ∮ min(max(x, a), b) dy along the contour within the
// strip, x along the rows. So only those windows are cut from the region that are worth a road.
#pragma once

#include <cstdint>
#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/row_turn.h"  // RowTurn

namespace core {

// Row n lies at (n + ½) · distance; from <= to, in units along it.
struct RowStretch {
  std::int64_t row = 0;
  double from = 0, to = 0;
  bool from_covered = false, to_covered = false;  // another road covers what is beyond the end
};

struct RowStrips {
  RowTurn turn;
  double distance = 0;  // units
  double reach = 0;     // likewise: how far a road covers beyond its end
};

// The rests of windows that hold more than `least_mm2` and lie beyond no covered end.
// REQUIRES: stretches in the order of rows. COSTS: O(points + strips passed), and in each strip
// its contours times its windows; an intersection where a window is worth it.
[[nodiscard]] Region row_rests(const Region& region, const std::vector<RowStretch>& stretches,
                               const RowStrips& grid, double least_mm2);

}  // namespace core
