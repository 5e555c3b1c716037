// Two sides of a facet as directions, and the direction that it faces.
#pragma once

#include "core/geometry.h"  // Triangle

namespace core {

// In units.
struct Direction {
  double x = 0;
  double y = 0;
  double z = 0;

  [[nodiscard]] double length_squared() const { return x * x + y * y + z * z; }
};

// From the first corner to the others.
struct FacetSides {
  Direction to_second;
  Direction to_third;

  explicit FacetSides(const Triangle& triangle)
      : to_second(between(triangle.corners[0], triangle.corners[1])),
        to_third(between(triangle.corners[0], triangle.corners[2])) {}

  // As long as twice the facet's area; towards the side that sees its corners counter-clockwise.
  [[nodiscard]] Direction normal() const {
    const auto& [u, v] = *this;
    return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  }

 private:
  [[nodiscard]] static Direction between(const Vertex& from, const Vertex& to) {
    return {static_cast<double>(to.x) - from.x, static_cast<double>(to.y) - from.y,
            static_cast<double>(to.z - from.z)};
  }
};

}  // namespace core
