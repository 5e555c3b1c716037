// The convex hull of points, and how broad it is.
//
//     ╭─────────╮  ┬
//     │         │  │ least breadth: of all pairs of parallel lines that enclose the hull, the two
//     ╰─────────╯  ┴ nearest to each other. One of them lies on an edge (rotating calipers:
//     ├─length──┤   Shamos 1978, Toussaint 1983).
#pragma once

#include <vector>

#include "core/geometry.h"  // Point, Ring

namespace core {

// Counter-clockwise from the least point (by x, then y), without points within edges. One point or
// two where all lie on a line. REQUIRES: coordinates within ±kCoordinateMax. COSTS: O(n log n).
[[nodiscard]] Ring convex_hull(std::vector<Point> points);

struct Breadth {
  double least_mm = 0;
  double length_mm = 0;  // across the least breadth
};

// REQUIRES: a hull as above. 0 where it has fewer than three points. COSTS: O(points).
[[nodiscard]] Breadth breadth_of(const Ring& hull);

}  // namespace core
