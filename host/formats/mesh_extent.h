// The bounding box of a mesh, and how far it reaches between the axes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/geometry.h"  // Box, Point, Triangle

namespace host {

// Directions in the plane in which the farthest points are kept, both ways, for beds that are no
// rectangle: every 22.5°, nearly.
inline constexpr std::array<core::Point, 8> kReachDirections = {
    core::Point{1, 0}, {5, 2}, {1, 1}, {2, 5}, {0, 1}, {-2, 5}, {-1, 1}, {-5, 2}};

// The points of a mesh that lie farthest along each of these directions, and against it. Starts
// empty. COSTS: eight products a point.
class Reach {
 public:
  void add(core::Point point);
  void add(const Reach& other);

  // Empty, or two points for each direction.
  [[nodiscard]] const std::vector<core::Point>& points() const { return points_; }

 private:
  std::vector<core::Point> points_;
  std::array<std::int64_t, kReachDirections.size()> lowest_{};
  std::array<std::int64_t, kReachDirections.size()> highest_{};
};

// In the mesh's own coordinates. Starts empty.
struct MeshExtent {
  core::Box box;
  Reach reach;  // may be less than all of the mesh
  std::int64_t lowest_z = std::numeric_limits<std::int64_t>::max();
  std::int64_t highest_z = std::numeric_limits<std::int64_t>::min();

  void add(const core::Triangle& triangle);
  void add(const MeshExtent& other);
  [[nodiscard]] bool holds(const core::Triangle& triangle) const;
};

}  // namespace host
