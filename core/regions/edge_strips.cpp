#include "core/regions/edge_strips.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace core {

EdgeStrips::EdgeStrips(std::vector<Segment> edges) : edges_(std::move(edges)) {
  Box box;
  std::int64_t rise = 0;  // of all edges
  for (const Segment& edge : edges_) {
    if (edge.from.y == edge.to.y) continue;
    box.add(edge.from);
    box.add(edge.to);
    rise += std::abs(std::int64_t{edge.from.y} - edge.to.y);
  }
  if (rise == 0) return;
  const auto count = static_cast<std::int64_t>(edges_.size());
  bottom_ = box.min.y;
  top_ = box.max.y;
  height_ = 1 + std::max((top_ - bottom_ + 1) / count, rise / (kEntriesPerEdge * count));
  starts_.assign(static_cast<std::size_t>(strip(top_)) + 2, 0);
  const auto for_strips = [this](const Segment& edge, const auto& visit) {
    if (edge.from.y == edge.to.y) return;
    const auto [low, high] = std::minmax(edge.from.y, edge.to.y);
    for (std::int64_t i = strip(low); i <= strip(high); ++i) visit(static_cast<std::size_t>(i));
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

std::span<const std::uint32_t> EdgeStrips::at(std::int32_t y) const {
  if (y < bottom_ || y > top_) return {};
  const auto i = static_cast<std::size_t>(strip(y));
  return std::span(entries_).subspan(starts_[i], starts_[i + 1] - starts_[i]);
}

}  // namespace core
