// Snaps corners in mm to the grid.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "core/geometry.h"               // Vertex
#include "core/units.h"                  // kUnitsPerMm
#include "host/formats/format_limits.h"  // kPlaneMaxMm, kHeightMaxMm

namespace host {

using PointMm = std::array<double, 3>;

// Halves away from zero, as std::llround, without a call. REQUIRES: |units| < 2^63.
[[nodiscard]] inline std::int64_t nearest_unit(double units) {
  const auto whole = static_cast<std::int64_t>(units);
  const double rest = units - static_cast<double>(whole);  // exact
  return whole + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0);
}

// Nullopt if not finite or out of range (format_limits.h). vertex_too_far() is the message.
[[nodiscard]] inline std::optional<core::Vertex> snapped_vertex(const PointMm& mm) {
  const auto& [x, y, z] = mm;
  // NaN compares as false.
  const bool fits =
      std::abs(x) <= kPlaneMaxMm && std::abs(y) <= kPlaneMaxMm && std::abs(z) <= kHeightMaxMm;
  if (!fits) return std::nullopt;
  return core::Vertex{static_cast<std::int32_t>(nearest_unit(x * core::kUnitsPerMm)),
                      static_cast<std::int32_t>(nearest_unit(y * core::kUnitsPerMm)),
                      nearest_unit(z * core::kUnitsPerMm)};
}
[[nodiscard]] std::string vertex_too_far(const PointMm& mm);

}  // namespace host
