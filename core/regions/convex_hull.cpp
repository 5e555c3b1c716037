#include "core/regions/convex_hull.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/trigonometry.h"  // hypotenuse
#include "core/units.h"         // kUnitsPerMm

namespace core {
namespace {

double length_units(Point a, Point b) {
  return hypotenuse(static_cast<double>(b.x) - a.x, static_cast<double>(b.y) - a.y);
}

// Extent of the ring along a → b, in units.
double extent_along(const Ring& ring, Point a, Point b) {
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  std::int64_t least = 0, most = 0;
  for (const Point p : ring) {
    const std::int64_t along = dx * (std::int64_t{p.x} - a.x) + dy * (std::int64_t{p.y} - a.y);
    least = std::min(least, along);
    most = std::max(most, along);
  }
  return (static_cast<double>(most) - static_cast<double>(least)) / length_units(a, b);
}

}  // namespace

// A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
Ring convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Ring hull;
  const auto add = [&hull](Point p, std::size_t kept) {
    while (hull.size() > kept && cross(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
    hull.push_back(p);
  };
  for (const Point p : points) add(p, 1);
  const std::size_t lower = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  hull.pop_back();
  return hull;
}

Breadth breadth_of(const Ring& hull) {
  const std::size_t count = hull.size();
  if (count < 3) return {};
  const auto at = [&](std::size_t i) { return hull[i % count]; };
  double least_units = 0;
  std::size_t least_edge = count;
  std::size_t far = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const Point a = at(i), b = at(i + 1);
    far = std::max(far, i + 1);
    while (cross(a, b, at(far + 1)) > cross(a, b, at(far))) ++far;
    const double breadth = static_cast<double>(cross(a, b, at(far))) / length_units(a, b);
    if (least_edge < count && breadth >= least_units) continue;
    least_units = breadth;
    least_edge = i;
  }
  return {least_units / kUnitsPerMm,
          extent_along(hull, at(least_edge), at(least_edge + 1)) / kUnitsPerMm};
}

}  // namespace core
