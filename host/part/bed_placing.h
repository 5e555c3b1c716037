// Places a mesh on the bed and checks that it fits.
//
// The lowest point is at height 0. In the plane, the centre of the mesh's box is at the bed's
// centre, or the box's front left corner is where the settings say.
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

// kOutOfBounds if the mesh is larger than the bed or the axis, or would lie outside. The message
// starts with `name` and gives the mesh's dimensions and what to do. On a bed that is no rectangle,
// the mesh's farthest points are checked here, and its roads later (layer_rules.h).
[[nodiscard]] core::Status check_on_bed(const MeshExtent& extent, const Shift& shift,
                                        const core::Settings& settings, const std::string& name);

// "12.3", without trailing zeros.
[[nodiscard]] std::string mm_text(std::int64_t units);

}  // namespace host
