#include "core/supports/dense_parts.h"

#include "core/regions/polyline.h"  // between

namespace core {

std::vector<std::pair<Road, bool>> DenseParts::of(Road road) const {
  std::vector<std::pair<Road, bool>> parts;
  if (empty_) {
    parts.emplace_back(std::move(road), false);
    return parts;
  }
  const std::vector<Station> way = stations(road);
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (way[i].at == way[i - 1].at) continue;
    const bool dense = inside_.contains(between(way[i - 1].at, way[i].at, 0.5));
    if (parts.empty() || parts.back().second != dense) {
      parts.emplace_back(started(road, way[i - 1]), dense);
    }
    go_on(way[i], parts.back().first);
  }
  if (parts.size() == 1) parts.front().first = std::move(road);
  return parts;
}

// The road's points and those at which it crosses a contour; a closed one's first point twice.
std::vector<DenseParts::Station> DenseParts::stations(const Road& road) const {
  std::vector<Station> way;
  const std::size_t count = road.points.size();
  std::vector<BoundaryPoint> crossings;
  for (std::size_t i = 0; i < count; ++i) {
    way.push_back({road.points[i], width_at(road, i)});
    if (i + 1 == count && !road.closed) break;
    const std::size_t next = i + 1 < count ? i + 1 : 0;
    crossings.clear();
    contours_.append_crossings(road.points[i], road.points[next], crossings);
    for (const BoundaryPoint& crossing : crossings) {
      way.push_back({crossing.at, width_at(road, i)});
    }
  }
  if (road.closed) way.push_back(way.front());
  return way;
}

Road DenseParts::started(const Road& like, const Station& at) {
  Road part{like.kind, like.width, false, {at.at}};
  if (!like.widths.empty()) part.widths.push_back(at.width);
  return part;
}

void DenseParts::go_on(const Station& to, Road& part) {
  part.points.push_back(to.at);
  if (!part.widths.empty()) part.widths.push_back(to.width);
}

}  // namespace core
