#include "host/formats/vertex_snap.h"

#include <cmath>

#include "host/formats/number_text.h"  // number_text

namespace host {

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
