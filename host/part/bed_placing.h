// Where a mesh comes to lie on the bed, and whether it fits there.
//
// Lowest point at height 0; in the plane the middle of its box at the middle of the bed, or the
// box's lowest corner where the settings say.
#pragma once

#include <cstdint>
#include <string>

#include "core/geometry.h"             // Box, Point, Triangle
#include "core/result.h"               // Status
#include "core/settings.h"             // Settings
#include "host/formats/mesh_extent.h"  // MeshExtent

namespace host {

struct Shift {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t z = 0;
};

// REQUIRES: the extent is not empty.
[[nodiscard]] Shift shift_to_bed(const MeshExtent& extent, const core::Settings& settings);

// REQUIRES: the extent of all that is shifted passed check_on_bed().
[[nodiscard]] core::Triangle shifted(core::Triangle triangle, const Shift& shift);
[[nodiscard]] core::Box shifted(const core::Box& box, const Shift& shift);

// kOutOfBounds for a mesh that is larger than the bed or the axis, or would lie outside; the
// message gives its measures and what to do, and begins with `name`.
[[nodiscard]] core::Status check_on_bed(const MeshExtent& extent, const Shift& shift,
                                        const core::Settings& settings, const std::string& name);

// "12.3", without zeros at the end.
[[nodiscard]] std::string mm_text(std::int64_t units);

}  // namespace host
