// The bounding box of a mesh.
#pragma once

#include <cstdint>
#include <limits>

#include "core/geometry.h"  // Box, Triangle

namespace host {

// In the mesh's own coordinates. Starts empty.
struct MeshExtent {
  core::Box box;
  std::int64_t lowest_z = std::numeric_limits<std::int64_t>::max();
  std::int64_t highest_z = std::numeric_limits<std::int64_t>::min();

  void add(const core::Triangle& triangle);
  [[nodiscard]] bool holds(const core::Triangle& triangle) const;
};

}  // namespace host
