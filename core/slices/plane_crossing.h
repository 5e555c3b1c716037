// Where an edge of a mesh crosses a plane. Heights of planes are doubled, so that halves are whole
// numbers.
#pragma once

#include <cstdint>

#include "core/geometry.h"  // Point, Vertex

namespace core {

// A corner on the plane counts as above it.
[[nodiscard]] inline bool is_above(const Vertex& vertex, std::int64_t doubled_z) {
  return 2 * vertex.z >= doubled_z;
}

// Computed from the lower to the upper end, so that both triangles on an edge get the same point,
// bit for bit: rounded once, in integers. REQUIRES: one end is above the plane, the other is not.
[[nodiscard]] Point plane_crossing(Vertex a, Vertex b, std::int64_t doubled_z);

}  // namespace core
