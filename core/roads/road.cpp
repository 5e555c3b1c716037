#include "core/roads/road.h"

#include <cmath>
#include <numbers>

#include "core/regions/polyline.h"  // length_mm

namespace core {

double length_mm(const Road& road) { return length_mm(road.points, road.closed); }

double bead_area_mm2(Length width, Length height) {
  const double w = width.mm();
  const double h = height.mm();
  if (w < h) return std::numbers::pi * w * h / 4;
  return h * (w - h) + std::numbers::pi * h * h / 4;
}

}  // namespace core
