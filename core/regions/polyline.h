// Small measures on points and polylines.
#pragma once

#include <cmath>
#include <vector>

#include "core/geometry.h"  // Point, Segment
#include "core/rounded.h"   // rounded
#include "core/units.h"     // kUnitsPerMm
#include "core/vector.h"    // Vector, share_along

namespace core {

[[nodiscard]] inline double distance_units(Point a, Point b) {
  const double dx = static_cast<double>(b.x) - a.x;
  const double dy = static_cast<double>(b.y) - a.y;
  return std::sqrt(dx * dx + dy * dy);
}

[[nodiscard]] inline double distance_mm(Point a, Point b) {
  return distance_units(a, b) / kUnitsPerMm;
}

// To the nearest point of the segment.
[[nodiscard]] inline double distance_units(Point point, const Segment& segment) {
  const Vector along = to_vector(segment.to) - to_vector(segment.from);
  const Vector to = to_vector(point) - to_vector(segment.from);
  const Vector off = to - along * share_along(to, along);
  return std::sqrt(dot(off, off));
}

// The way back to the start included where closed.
[[nodiscard]] inline double length_mm(const std::vector<Point>& points, bool closed) {
  double sum = closed ? distance_mm(points.back(), points.front()) : 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance_mm(points[i - 1], points[i]);
  return sum;
}

// Between a and b, at share t of the way.
[[nodiscard]] inline Point between(Point a, Point b, double t) {
  const double x = a.x + t * (static_cast<double>(b.x) - a.x);
  const double y = a.y + t * (static_cast<double>(b.y) - a.y);
  return {rounded(x), rounded(y)};
}

}  // namespace core
