#include "host/formats/vertex_snap.h"

#include <cmath>

#include "core/units.h"                  // kUnitsPerMm
#include "host/formats/format_limits.h"  // kPlaneMaxMm
#include "host/formats/number_text.h"    // number_text

namespace host {

std::optional<core::Vertex> snapped_vertex(const PointMm& mm) {
  const auto& [x, y, z] = mm;
  // NaN compares as false.
  const bool fits =
      std::abs(x) <= kPlaneMaxMm && std::abs(y) <= kPlaneMaxMm && std::abs(z) <= kHeightMaxMm;
  if (!fits) return std::nullopt;
  return core::Vertex{static_cast<std::int32_t>(std::llround(x * core::kUnitsPerMm)),
                      static_cast<std::int32_t>(std::llround(y * core::kUnitsPerMm)),
                      std::llround(z * core::kUnitsPerMm)};
}

std::string vertex_too_far(const PointMm& mm) {
  const auto& [x, y, z] = mm;
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
    return "a coordinate is not a finite number; repair the mesh";
  }
  return "a corner is at " + number_text(x) + ", " + number_text(y) + ", " + number_text(z) +
         " mm, farther than " + number_text(kPlaneMaxMm) + " mm (or " + number_text(kHeightMaxMm) +
         " mm in height) from the origin; move the part to the origin, or check its unit";
}

}  // namespace host
