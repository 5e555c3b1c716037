// Where a straight edge and the grid's pixels meet, in exact arithmetic.
//
// A pixel is the unit square about a grid point p, closed below and left, open above and right, so
// that every point of the plane lies in exactly one:
//
//     [p.x − ½, p.x + ½) × [p.y − ½, p.y + ½)
#pragma once

#include <cstdint>
#include <cstdlib>

#include "core/geometry.h"  // Point, cross

namespace core {

[[nodiscard]] inline bool between(std::int32_t a, std::int32_t value, std::int32_t b) {
  return a <= b ? a <= value && value <= b : b <= value && value <= a;
}

// Whether the edge a -> b passes the pixel of p.
//
// The line passes it if corners of the pixel lie on both sides: at the corner p + (±½, ±½), twice
// the cross product is 2c ± dx ± dy. If the line only touches a corner, it must be the lower left
// one. The edge's ends are the middles of pixels, so of the pixels on its line it passes those
// within its box.
// REQUIRES: coordinates within ±2^29 (2c is below 2^63 then).
[[nodiscard]] inline bool passes_pixel(Point a, Point b, Point p) {
  if (!between(a.x, p.x, b.x) || !between(a.y, p.y, b.y)) return false;
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const std::int64_t doubled = 2 * cross(a, b, p);
  const std::int64_t reach = std::abs(dx) + std::abs(dy);
  if (std::abs(doubled) != reach) return std::abs(doubled) < reach;
  return doubled + dy - dx == 0;
}

// The pixel in which a -> b and c -> d cross.
// REQUIRES: they cross at one point that is inside both.
[[nodiscard]] Point crossing_pixel(Point a, Point b, Point c, Point d);

}  // namespace core
