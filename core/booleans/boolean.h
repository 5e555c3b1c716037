// Set operations on regions (polygon clipping), and the way from any rings to a clean region.
//
// Results are regularised: the closure of their interior, without parts of no area. Crossing
// points are rounded to the grid, so results can differ from exact ones by slivers up to 2 units
// wide, and the operations are associative only up to such slivers.
//
// Results are canonical, whatever the order of the operands: every ring starts at its least point
// (by x, then y), and rings are sorted by their first points. No ring passes a point twice at
// which operands met. overlay.h says how it is done.
//
// Each thread keeps the memory that its operations need on the way. In the steady state, only the
// results are allocated.
//
// Keywords: union, intersection, difference, xor, clipping.
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

// The same, and the lowest winding number that the rings have anywhere, or 0. A negative one says
// that something is turned inside out.
struct CleanedRings {
  Region region;
  std::int32_t least_winding = 0;
};
[[nodiscard]] CleanedRings clean_with_winding(const std::vector<Ring>& rings, FillRule rule);

// Equal, empty and far operands cost a comparison.
[[nodiscard]] Region unite(const Region& a, const Region& b);
[[nodiscard]] Region intersect(const Region& a, const Region& b);
[[nodiscard]] Region subtract(const Region& a, const Region& b);
// The same for b within a, touching none of its contours: nothing has to be cut.
// COSTS: a copy. Canonical where both are.
[[nodiscard]] Region subtract_within(const Region& a, const Region& b);
[[nodiscard]] Region exclusive_or(const Region& a, const Region& b);

// How many operations of the calling thread found that an operand was not clean, and were done
// again with every edge tried against every other. 0 unless something is wrong.
[[nodiscard]] std::int64_t boolean_retries();

}  // namespace core
