// Leaves out points that a contour doesn't need (polyline simplification).
//
// There are two steps. The first leaves out points that lie on a straight line except for rounding
// to the grid: the facets of one slanted plane leave such points. The second is
// Ramer–Douglas–Peucker (Ramer 1972; Douglas and Peucker 1973): a run of points is replaced by its
// chord where all of it lies within the tolerance; otherwise it is split at its farthest point.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry.h"  // Point, Ring
#include "core/units.h"     // Length

namespace core {

// The same ring from whichever point it starts. Empty where nothing with an area is left.
//
// ENSURES: every point of `ring` is within `tolerance` + 1 unit of the result, whose points are
// points of `ring`. The result may cross itself or other rings where they come that close.
// COSTS: O(n log n) on ordinary contours; at worst O(n · kSimplifyRunMax).
[[nodiscard]] Ring simplify(const Ring& ring, Length tolerance);

// For an open line, whose ends stay: the numbers of the points to keep, in their order. Each time
// the farthest point to which a straight line passes all those between within the tolerance (cone
// intersection; Williams 1978). COSTS: O(n).
[[nodiscard]] std::vector<std::size_t> kept_points(const std::vector<Point>& line,
                                                   Length tolerance);

// Longest run of points that is looked at as one; longer ones are split in advance.
inline constexpr int kSimplifyRunMax = 1024;

}  // namespace core
