#include "core/supports/tree_obstacle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/regions/polyline.h"  // between, distance_units
#include "core/vector.h"            // Vector, share_along

namespace core {
namespace {

// How far beyond a contour a free point is looked for, in units: less than a step is short.
constexpr std::int32_t kBeyond[] = {1, 2, 4};

// So many places of the contour are tried.
constexpr std::size_t kTriesMax = 8;

Point nearest_on(const Segment& edge, Point to) {
  const Vector along = to_vector(edge.to) - to_vector(edge.from);
  return between(edge.from, edge.to, share_along(to_vector(to) - to_vector(edge.from), along));
}

Box box_around(Point point, Length reach) {
  const auto r = static_cast<std::int32_t>(reach.units());
  return {{point.x - r, point.y - r}, {point.x + r, point.y + r}};
}

}  // namespace

std::optional<Point> TreeObstacle::nearest_free(Point point, Length within) const {
  if (!blocks(point)) return point;
  std::vector<std::uint32_t> numbers;
  grid_.collect(box_around(point, within), numbers);
  std::vector<std::pair<double, Point>> places;
  for (const std::uint32_t number : numbers) {
    const Point at = nearest_on(edges_[number], point);
    const double distance = distance_units(point, at);
    if (distance <= static_cast<double>(within.units())) places.emplace_back(distance, at);
  }
  std::sort(places.begin(), places.end());
  if (places.size() > kTriesMax) places.resize(kTriesMax);
  for (const auto& place : places) {
    for (const std::int32_t beyond : kBeyond) {
      for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const Point tried{place.second.x + x * beyond, place.second.y + y * beyond};
        if (!blocks(tried) && distance_units(point, tried) <= static_cast<double>(within.units())) {
          return tried;
        }
      }
    }
  }
  // A corner of what is free may be too sharp to have a point of the grid in it, but for its end.
  if (places.empty()) return {};
  return places.front().second;
}

std::optional<Point> TreeObstacle::nearest_edge(Point point, Length within) const {
  std::vector<std::uint32_t> numbers;
  grid_.collect(box_around(point, within), numbers);
  std::optional<Point> found;
  double least = static_cast<double>(within.units());
  for (const std::uint32_t number : numbers) {
    const Point at = nearest_on(edges_[number], point);
    const double distance = distance_units(point, at);
    if (distance >= least) continue;
    least = distance;
    found = at;
  }
  return found;
}

}  // namespace core
