#include "core/regions/point_location.h"

#include <algorithm>
#include <numeric>

namespace core {

PointLocation::PointLocation(const Region& region) {
  std::int64_t rise = 0;  // of all edges
  for (const Segment& edge : edges_of(region.rings())) {
    if (edge.from.y == edge.to.y) continue;
    edges_.push_back(edge);
    box_.add(edge.from);
    box_.add(edge.to);
    rise += std::abs(std::int64_t{edge.from.y} - edge.to.y);
  }
  if (edges_.empty()) return;
  const auto count = static_cast<std::int64_t>(edges_.size());
  bottom_ = box_.min.y;
  const std::int64_t high = std::int64_t{box_.max.y} - bottom_ + 1;
  height_ = 1 + std::max(high / count, rise / (kEntriesPerEdge * count));
  starts_.assign(static_cast<std::size_t>(strip(box_.max.y)) + 2, 0);
  const auto for_strips = [this](const Segment& edge, const auto& visit) {
    const auto [low, top] = std::minmax(edge.from.y, edge.to.y);
    for (std::int64_t i = strip(low); i <= strip(top); ++i) visit(static_cast<std::size_t>(i));
  };
  for (const Segment& edge : edges_) {
    for_strips(edge, [this](std::size_t i) { ++starts_[i + 1]; });
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  entries_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t number = 0; number < edges_.size(); ++number) {
    for_strips(edges_[number], [&](std::size_t i) { entries_[next[i]++] = number; });
  }
}

// The winding number, from the edges on the point's left.
bool PointLocation::contains(Point point) const {
  if (edges_.empty() || !box_.overlaps({point, point})) return false;
  const auto i = static_cast<std::size_t>(strip(point.y));
  int winding = 0;
  for (std::uint32_t at = starts_[i]; at < starts_[i + 1]; ++at) {
    const Segment& edge = edges_[entries_[at]];
    const bool from_above = edge.from.y > point.y, to_above = edge.to.y > point.y;
    if (from_above == to_above) continue;
    const std::int64_t side = cross(edge.from, edge.to, point);
    if (to_above && side < 0) ++winding;
    if (from_above && side > 0) --winding;
  }
  return winding != 0;
}

}  // namespace core
