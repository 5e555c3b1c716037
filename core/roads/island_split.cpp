#include "core/roads/island_split.h"

#include <limits>
#include <utility>

namespace core {

IslandSplit::IslandSplit(const Region& slice) {
  for (Island& island : core::islands(slice)) islands_.push_back(region_of(std::move(island)));
  if (islands_.size() < 2) return;
  std::vector<Segment> edges;
  for (std::uint32_t island = 0; island < islands_.size(); ++island) {
    const std::vector<Segment> more = edges_of(islands_[island].rings());
    edges.insert(edges.end(), more.begin(), more.end());
    island_of_.resize(edges.size(), island);
  }
  edges_ = EdgeStrips(std::move(edges));
}

std::uint32_t IslandSplit::island_at(Point point) const {
  std::uint32_t island = 0;
  double nearest = std::numeric_limits<double>::max();
  for (const std::uint32_t number : edges_.at(point.y)) {
    const Segment& edge = edges_[number];
    if ((edge.from.y > point.y) == (edge.to.y > point.y)) continue;
    const double share = (static_cast<double>(point.y) - edge.from.y) /
                         (static_cast<double>(edge.to.y) - edge.from.y);
    const double x = edge.from.x + share * (static_cast<double>(edge.to.x) - edge.from.x);
    if (x > point.x || point.x - x >= nearest) continue;
    nearest = point.x - x;
    island = island_of_[number];
  }
  return island;
}

std::vector<Region> IslandSplit::split(Region region) const {
  if (islands_.size() == 1) {
    std::vector<Region> one;
    one.push_back(std::move(region));
    return one;
  }
  std::vector<std::vector<Ring>> rings(islands_.size());
  if (!islands_.empty()) {
    for (const Ring& ring : region.rings()) rings[island_at(ring.front())].push_back(ring);
  }
  std::vector<Region> parts;
  parts.reserve(rings.size());
  for (std::vector<Ring>& part : rings) parts.push_back(Region::from_clean_rings(std::move(part)));
  return parts;
}

}  // namespace core
