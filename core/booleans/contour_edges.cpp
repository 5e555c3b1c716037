#include "core/booleans/contour_edges.h"

#include <cstdlib>

#include "core/check.h"  // RIND_DCHECK

namespace core {

void ContourEdges::clear() {
  points_.clear();
  ring_of_.clear();
  rings_.clear();
  length_units_ = 0;
}

void ContourEdges::add(const Ring& ring, std::int32_t weight, std::uint32_t operand) {
  RIND_DCHECK(ring.size() >= 3);
  const EdgeIndex first = index_end();
  points_.insert(points_.end(), ring.begin(), ring.end());
  close_ring(first, weight, operand);
}

void ContourEdges::add_mended(const Ring& ring, std::int32_t weight, std::uint32_t operand) {
  const EdgeIndex first = index_end();
  const auto drop_straight = [&](Point next) {
    while (points_.size() >= first + 2u &&
           cross(points_[points_.size() - 2], points_.back(), next) == 0) {
      points_.pop_back();
    }
    return points_.size() == first || points_.back() != next;
  };
  for (const Point p : ring) {
    if (drop_straight(p)) points_.push_back(p);
  }
  // Around the joint, from both sides, until neither gives.
  std::size_t start = first;
  for (bool changed = true; changed && points_.size() >= start + 3;) {
    changed = false;
    const std::size_t size = points_.size();
    if (points_.back() == points_[start] ||
        cross(points_[size - 2], points_.back(), points_[start]) == 0) {
      points_.pop_back();
      changed = true;
    } else if (cross(points_.back(), points_[start], points_[start + 1]) == 0) {
      ++start;
      changed = true;
    }
  }
  points_.erase(points_.begin() + first, points_.begin() + static_cast<std::ptrdiff_t>(start));
  if (points_.size() < first + 3u) {
    points_.resize(first);
    return;
  }
  close_ring(first, weight, operand);
}

void ContourEdges::close_ring(EdgeIndex first, std::int32_t weight, std::uint32_t operand) {
  RIND_DCHECK(rings_.empty() || rings_.back().operand <= operand);
  const EdgeIndex end = index_end();
  const Point joint = points_[first];
  points_.push_back(joint);
  for (EdgeIndex i = first; i < end; ++i) {
    const Point a = points_[i], b = points_[i + 1];
    length_units_ += static_cast<std::uint32_t>(std::abs(b.x - a.x)) +
                     static_cast<std::uint32_t>(std::abs(b.y - a.y));
  }
  ring_of_.resize(points_.size(), static_cast<std::uint32_t>(rings_.size()));
  rings_.push_back({first, end, weight, operand});
}

}  // namespace core
