// Set operations on regions, and the way from any rings to a clean region.
//
// Regularised: the result is the closure of its interior, so that nothing without area remains.
// Crossing points are rounded to the grid; results can differ from exact ones by slivers up to
// 2 units wide, and the operations are associative only up to such slivers.
//
// Results are canonical: every ring starts at its least point (by x, then y) and rings stand in the
// order of their first points, whatever the order of the operands. No ring passes a point twice at
// which operands met. How it is done stands in overlay.h.
//
// Each thread keeps the memory that its operations need on the way, so that in the steady state
// nothing but the results is allocated.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry.h"        // Ring
#include "core/regions/region.h"  // Region

namespace core {

// Which points rings of any kind enclose.
enum class FillRule {
  kNonZero,   // winding number other than 0: what a mesh's section means, whichever way it turns
  kPositive,  // winding number above 0
  kEvenOdd,   // winding number odd: contours that nest, whichever way they turn
};

// REQUIRES: coordinates within ±kCoordinateMax. Rings may cross, overlap, touch and degenerate.
// COSTS: near-linear in edges and crossings, as all that follow.
[[nodiscard]] Region clean(const std::vector<Ring>& rings, FillRule rule);

// The same, and the lowest winding number that the rings have anywhere, or 0: below it, something
// is turned inside out.
struct CleanedRings {
  Region region;
  std::int32_t least_winding = 0;
};
[[nodiscard]] CleanedRings clean_with_winding(const std::vector<Ring>& rings, FillRule rule);

// Equal, empty and far operands cost a comparison.
[[nodiscard]] Region unite(const Region& a, const Region& b);
[[nodiscard]] Region intersect(const Region& a, const Region& b);
[[nodiscard]] Region subtract(const Region& a, const Region& b);
// The same where b lies within a and touches none of its contours: nothing has to be cut.
// COSTS: a copy. Canonical where both are.
[[nodiscard]] Region subtract_within(const Region& a, const Region& b);
[[nodiscard]] Region exclusive_or(const Region& a, const Region& b);

// Operations of the calling thread that were done twice, everything tried against everything,
// because an operand that should have been clean crossed itself. 0 unless something is wrong.
[[nodiscard]] std::int64_t boolean_retries();

}  // namespace core
