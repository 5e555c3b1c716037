// A vector in the plane in double coordinates, and its products.
#pragma once

#include <algorithm>

#include "core/geometry.h"  // Point

namespace core {

struct Vector {
  double x = 0;
  double y = 0;
};

inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
inline Vector operator*(Vector a, double factor) { return {a.x * factor, a.y * factor}; }

[[nodiscard]] inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
// Positive when b points to the left of a.
[[nodiscard]] inline double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
// Turned by 90° counter-clockwise.
[[nodiscard]] inline Vector left_of(Vector a) { return {-a.y, a.x}; }

// Where `along` is nearest to the end of `to`, both from one start: a share of it, 0 … 1.
[[nodiscard]] inline double share_along(Vector to, Vector along) {
  const double squared = dot(along, along);
  return squared > 0 ? std::clamp(dot(to, along) / squared, 0.0, 1.0) : 0;
}

// Exact.
[[nodiscard]] inline Vector to_vector(Point p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

}  // namespace core
