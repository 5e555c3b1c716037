// Whether contours run along others within a reach, proven by one walk along both.
//
//     a ──●────────●──────▶     as one walks a dog: both only go forward, and a leash of that
//         ┆ leash  ┆            length never gets taut. Between two steps both move along straight
//     b ──●───────●───────▶     lines, so the leash is never longer than at the steps.
//
// An offset and its contour pass as a rule, so that no grid of segments has to be built to ask
// point after point (segment_grid.h). The walk is a bound on the Fréchet distance of the two
// (Alt and Godau, 1995); a greedy one, so that a no means "not proven".
#pragma once

#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

// True only when every point of `contours` is within `reach` of a point on the ring of `others`
// that has the same number. COSTS: O(points), no allocation.
[[nodiscard]] bool frechet_within(const Region& contours, const Region& others, Length reach);

// Whether `contours` stay within `reach` of the others: proven by the leash, or else looked at
// every `step` or less. COSTS: O(points), and a grid of segments where the leash does not prove it.
[[nodiscard]] bool stays_near(const Region& contours, const Region& others, Length reach,
                              Length step);

}  // namespace core
