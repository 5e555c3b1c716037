#include "core/roads/island_split.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace core {

IslandSplit::IslandSplit(const Region& slice) {
  for (Island& island : core::islands(slice)) islands_.push_back(region_of(std::move(island)));
  if (islands_.size() < 2) return;
  const Box box = slice.box();
  for (std::uint32_t island = 0; island < islands_.size(); ++island) {
    for (const Segment& edge : edges_of(islands_[island].rings())) {
      if (edge.from.y != edge.to.y) edges_.push_back({edge.from, edge.to, island});
    }
  }
  const auto rows = static_cast<std::int64_t>(std::sqrt(static_cast<double>(edges_.size()))) + 1;
  bottom_ = box.min.y;
  row_height_ = (std::int64_t{box.max.y} - box.min.y) / rows + 1;
  starts_.assign(static_cast<std::size_t>(rows) + 2, 0);
  const auto for_rows = [&](const Edge& edge, const auto& visit) {
    const std::size_t last = row_of(std::max(edge.from.y, edge.to.y));
    for (std::size_t row = row_of(std::min(edge.from.y, edge.to.y)); row <= last; ++row) visit(row);
  };
  for (const Edge& edge : edges_) for_rows(edge, [&](std::size_t row) { ++starts_[row]; });
  std::uint32_t sum = 0;
  for (std::uint32_t& start : starts_) start = (sum += start);
  in_rows_.resize(sum);
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    for_rows(edges_[i], [&](std::size_t row) { in_rows_[--starts_[row]] = i; });
  }
}

std::size_t IslandSplit::row_of(std::int32_t y) const {
  return static_cast<std::size_t>((y - bottom_) / row_height_);
}

std::uint32_t IslandSplit::island_at(Point point) const {
  std::uint32_t island = 0;
  double nearest = std::numeric_limits<double>::max();
  if (point.y < bottom_ || row_of(point.y) + 1 >= starts_.size()) return island;
  const std::size_t row = row_of(point.y);
  for (std::uint32_t i = starts_[row]; i < starts_[row + 1]; ++i) {
    const Edge& edge = edges_[in_rows_[i]];
    if ((edge.from.y > point.y) == (edge.to.y > point.y)) continue;
    const double share = (static_cast<double>(point.y) - edge.from.y) /
                         (static_cast<double>(edge.to.y) - edge.from.y);
    const double x = edge.from.x + share * (static_cast<double>(edge.to.x) - edge.from.x);
    if (x > point.x || point.x - x >= nearest) continue;
    nearest = point.x - x;
    island = edge.island;
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
