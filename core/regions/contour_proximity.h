// Whether contours stay within a reach of other contours: proven by one walk along both.
//
//     a ──●────────●──────▶     Two walkers go along the contours, forwards only, and are never
//         ┆ reach  ┆            farther than `reach` from each other. Between two steps both move
//     b ──●───────●───────▶     along straight lines, so it is enough to check at the steps.
//
// An offset and its contour pass as a rule, so that no grid of segments has to be built to ask
// point after point (segment_grid.h). The walk is an upper bound on the Fréchet distance of the
// two (Alt and Godau, 1995). It is greedy, so "no" means "not proven".
#pragma once

#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

// True only when every ring of `contours` has one of `others` of its own, and all its points are
// within `reach` of points on that: the one of the same number, as a rule, or one whose first point
// is at a like x, as rings are sorted by it. COSTS: O(points), no allocation; where numbers differ,
// as much for each ring of like x.
[[nodiscard]] bool frechet_within(const Region& contours, const Region& others, Length reach);

// Whether `contours` stay within `reach` of the others: proven by the walk, or else sampled every
// `step` or less. COSTS: O(points), and a grid of segments where the walk does not prove it.
[[nodiscard]] bool stays_near(const Region& contours, const Region& others, Length reach,
                              Length step);

}  // namespace core
