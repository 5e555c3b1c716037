// Snaps corners in mm to the grid.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/geometry.h"  // Vertex

namespace host {

using PointMm = std::array<double, 3>;

// Nullopt if not finite or out of range (format_limits.h). vertex_too_far() is the message.
[[nodiscard]] std::optional<core::Vertex> snapped_vertex(const PointMm& mm);
[[nodiscard]] std::string vertex_too_far(const PointMm& mm);

}  // namespace host
