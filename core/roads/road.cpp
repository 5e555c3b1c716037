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
  road.starts.clear();
  const auto by = static_cast<std::ptrdiff_t>(index);
  std::rotate(road.points.begin(), road.points.begin() + by, road.points.end());
  if (!road.widths.empty()) {
    std::rotate(road.widths.begin(), road.widths.begin() + by, road.widths.end());
  }
  if (!road.holds.empty()) {
    std::rotate(road.holds.begin(), road.holds.begin() + by, road.holds.end());
  }
}

void start_at(Road& road, RingPlace place) {
  const std::size_t edge = place.edge;
  if (place.at == road.points[edge]) return start_at(road, edge);
  const std::size_t next = edge + 1 < road.points.size() ? edge + 1 : 0;
  const auto after = static_cast<std::ptrdiff_t>(edge) + 1;
  if (!road.widths.empty()) {
    const double whole = distance_mm(road.points[edge], road.points[next]);
    const double part = distance_mm(road.points[edge], place.at);
    const double from = road.widths[edge].mm(), to = road.widths[next].mm();
    const double here = from + (to - from) * std::min(1.0, part / whole);
    road.widths.insert(road.widths.begin() + after, Length::from_mm(here));
  }
  if (!road.holds.empty()) road.holds.insert(road.holds.begin() + after, road.holds[edge]);
  road.points.insert(road.points.begin() + after, place.at);
  start_at(road, edge + 1);
}

Road opened(Road road, Length gap) {
  if (!road.closed) return road;
  double left_mm = std::min(gap.mm(), length_mm(road) / 4);
  road.points.push_back(road.points.front());
  if (!road.widths.empty()) road.widths.push_back(road.widths.front());
  if (!road.holds.empty()) road.holds.push_back(road.holds.back());
  road.closed = false;
  while (left_mm > 0) {
    const std::size_t last = road.points.size() - 1;
    const double mm = distance_mm(road.points[last - 1], road.points[last]);
    if (mm > left_mm) {
      const double share = left_mm / mm;
      road.points[last] = between(road.points[last], road.points[last - 1], share);
      if (!road.widths.empty()) {
        const double to = road.widths[last].mm(), from = road.widths[last - 1].mm();
        road.widths[last] = Length::from_mm(to + (from - to) * share);
      }
      if (road.points[last] != road.points[last - 1]) break;
    }
    left_mm -= mm;
    road.points.pop_back();
    if (!road.widths.empty()) road.widths.pop_back();
    if (!road.holds.empty()) road.holds.pop_back();
  }
  return road;
}

double bead_area_mm2(Length width, Length height) {
  const double w = width.mm();
  const double h = height.mm();
  if (w < h) return std::numbers::pi * w * h / 4;
  return h * (w - h) + std::numbers::pi * h * h / 4;
}

Length bead_width(double area_mm2, Length height) {
  const double h = height.mm();
  const double ellipse = 4 * area_mm2 / (std::numbers::pi * h);
  return Length::from_mm(ellipse < h ? ellipse : area_mm2 / h + h * (1 - std::numbers::pi / 4));
}

double road_area_mm2(RoadKind kind, Length width, Length height) {
  return bead_area_mm2(width, kind == RoadKind::kBridge ? width : height);
}

double volume_mm3(const Road& road, Length height) {
  if (road.widths.empty()) return length_mm(road) * road_area_mm2(road.kind, road.width, height);
  const std::size_t count = road.points.size();
  double sum = 0;
  for (std::size_t i = 0; i < (road.closed ? count : count - 1); ++i) {
    const std::size_t j = (i + 1) % count;
    const double areas = road_area_mm2(road.kind, road.widths[i], height) +
                         road_area_mm2(road.kind, road.widths[j], height);
    sum += distance_mm(road.points[i], road.points[j]) * areas / 2;
  }
  return sum;
}

RoadKind laid_as(RoadKind kind, Hold hold) {
  const bool perimeter = kind == RoadKind::kOuterPerimeter || kind == RoadKind::kPerimeter;
  return perimeter && hold >= Hold::kQuarter ? RoadKind::kOverhangPerimeter : kind;
}

}  // namespace core
