#include "core/regions/point_location.h"

#include <cstdint>

namespace core {

// The winding number, from the edges on the point's left.
bool PointLocation::contains(Point point) const {
  if (!box_.overlaps({point, point})) return false;
  int winding = 0;
  for (const std::uint32_t number : edges_.at(point.y)) {
    const Segment& edge = edges_[number];
    const bool from_above = edge.from.y > point.y, to_above = edge.to.y > point.y;
    if (from_above == to_above) continue;
    const std::int64_t side = cross(edge.from, edge.to, point);
    if (to_above && side < 0) ++winding;
    if (from_above && side > 0) --winding;
  }
  return winding != 0;
}

}  // namespace core
