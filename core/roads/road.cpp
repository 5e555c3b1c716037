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

bool in_air(const Road& road) {
  if (road.holds.empty()) return false;
  const auto stretches = static_cast<std::ptrdiff_t>(road.points.size() - (road.closed ? 0 : 1));
  return std::all_of(road.holds.begin(), road.holds.begin() + stretches,
                     [](Hold hold) { return hold >= Hold::kQuarter; });
}

void reverse(Road& road) {
  std::reverse(road.points.begin(), road.points.end());
  std::reverse(road.widths.begin(), road.widths.end());
  // The stretch back to the start stays the last one.
  if (!road.holds.empty()) std::reverse(road.holds.begin(), road.holds.end() - 1);
}

void start_at(Road& road, std::size_t index) {
  RIND_CHECK(road.closed);
  const auto by = static_cast<std::ptrdiff_t>(index);
  std::rotate(road.points.begin(), road.points.begin() + by, road.points.end());
  if (!road.widths.empty()) {
    std::rotate(road.widths.begin(), road.widths.begin() + by, road.widths.end());
  }
  if (!road.holds.empty()) {
    std::rotate(road.holds.begin(), road.holds.begin() + by, road.holds.end());
  }
}

double bead_area_mm2(Length width, Length height) {
  const double w = width.mm();
  const double h = height.mm();
  if (w < h) return std::numbers::pi * w * h / 4;
  return h * (w - h) + std::numbers::pi * h * h / 4;
}

double road_area_mm2(RoadKind kind, Length width, Length height) {
  return bead_area_mm2(width, kind == RoadKind::kBridge ? width : height);
}

RoadKind laid_as(RoadKind kind, Hold hold) {
  const bool perimeter = kind == RoadKind::kOuterPerimeter || kind == RoadKind::kPerimeter;
  return perimeter && hold >= Hold::kQuarter ? RoadKind::kOverhangPerimeter : kind;
}

}  // namespace core
