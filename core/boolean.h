// Set operations on regions, and the way from any rings to a clean region.
//
// Regularised: the result is the closure of its interior, so that nothing without area remains.
// Crossing points are rounded to the grid; results can differ from exact ones by slivers up to
// 2 units wide, and the operations are associative only up to such slivers.
#pragma once

#include <vector>

#include "core/geometry.h"  // Ring
#include "core/region.h"    // Region

namespace core {

// Which points rings of any kind enclose.
enum class FillRule {
  kNonZero,   // winding number other than 0: what a mesh's section means, whichever way it turns
  kPositive,  // winding number above 0
};

// REQUIRES: coordinates within ±kCoordinateMax. Rings may cross, overlap, touch and degenerate.
[[nodiscard]] Region clean(const std::vector<Ring>& rings, FillRule rule);

[[nodiscard]] Region unite(const Region& a, const Region& b);
[[nodiscard]] Region intersect(const Region& a, const Region& b);
[[nodiscard]] Region subtract(const Region& a, const Region& b);
[[nodiscard]] Region exclusive_or(const Region& a, const Region& b);

}  // namespace core
