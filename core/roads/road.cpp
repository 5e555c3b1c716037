#include "core/roads/road.h"

#include <algorithm>
#include <numbers>

#include "core/check.h"             // RIND_CHECK
#include "core/regions/polyline.h"  // length_mm

namespace core {

double length_mm(const Road& road) { return length_mm(road.points, road.closed); }

Length widest(const Road& road) {
  return road.widths.empty() ? road.width
                             : *std::max_element(road.widths.begin(), road.widths.end());
}

void reverse(Road& road) {
  std::reverse(road.points.begin(), road.points.end());
  std::reverse(road.widths.begin(), road.widths.end());
}

void start_at(Road& road, std::size_t index) {
  RIND_CHECK(road.closed);
  const auto by = static_cast<std::ptrdiff_t>(index);
  std::rotate(road.points.begin(), road.points.begin() + by, road.points.end());
  if (road.widths.empty()) return;
  std::rotate(road.widths.begin(), road.widths.begin() + by, road.widths.end());
}

double bead_area_mm2(Length width, Length height) {
  const double w = width.mm();
  const double h = height.mm();
  if (w < h) return std::numbers::pi * w * h / 4;
  return h * (w - h) + std::numbers::pi * h * h / 4;
}

}  // namespace core
