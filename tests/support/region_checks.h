// Checks and measures of regions for tests.
#pragma once

#include <vector>

#include "core/geometry.h"        // Point, Ring
#include "core/regions/region.h"  // Region

namespace test {

// Checks every promise in region.h exactly, by brute force. COSTS: O(points²).
bool is_clean(const core::Region& region);

// Sum of the rings' winding numbers at (x, y), in units; the point should lie on no edge.
int winding_number(const std::vector<core::Ring>& rings, double x, double y);

// In units, to the nearest edge.
double distance_to_boundary(const std::vector<core::Ring>& rings, double x, double y);

// In units. REQUIRES: the segment has a length.
double distance_to_segment(core::Point point, const core::Segment& segment);

// Positive inside.
double signed_distance(const core::Region& region, double x, double y);

// Width in units (2 · area / perimeter) of the widest piece of the two regions' difference. Results
// of booleans are equal only up to slivers, so compare this with a bound, never use ==.
double widest_difference(const core::Region& a, const core::Region& b);

// Largest distance in units from a vertex of one boundary to the other boundary, both ways.
double boundary_distance(const core::Region& a, const core::Region& b);

}  // namespace test
