// A corner in mm on its way to the grid.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/geometry.h"  // Vertex

namespace host {

using PointMm = std::array<double, 3>;

// Nothing for one that is no number, or out of range (format_limits.h); and what to say then.
[[nodiscard]] std::optional<core::Vertex> snapped_vertex(const PointMm& mm);
[[nodiscard]] std::string vertex_too_far(const PointMm& mm);

}  // namespace host
