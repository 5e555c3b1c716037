#include "host/formats/mesh_extent.h"

#include <algorithm>

namespace host {

void MeshExtent::add(const core::Triangle& triangle) {
  for (const core::Vertex& corner : triangle.corners) box.add(core::Point{corner.x, corner.y});
  lowest_z = std::min(lowest_z, triangle.lowest_z());
  highest_z = std::max(highest_z, triangle.highest_z());
}

bool MeshExtent::holds(const core::Triangle& triangle) const {
  return std::all_of(triangle.corners.begin(), triangle.corners.end(), [this](const auto& corner) {
    return corner.x >= box.min.x && corner.x <= box.max.x && corner.y >= box.min.y &&
           corner.y <= box.max.y && corner.z >= lowest_z && corner.z <= highest_z;
  });
}

}  // namespace host
