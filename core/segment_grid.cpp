#include "core/segment_grid.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

int sign(std::int64_t value) { return (value > 0) - (value < 0); }

bool touch(const Segment& a, const Segment& b) {
  const int a0 = sign(cross(b.from, b.to, a.from));
  const int a1 = sign(cross(b.from, b.to, a.to));
  const int b0 = sign(cross(a.from, a.to, b.from));
  const int b1 = sign(cross(a.from, a.to, b.to));
  if (a0 == 0 && a1 == 0) {
    Box box_a, box_b;
    box_a.add(a.from), box_a.add(a.to);
    box_b.add(b.from), box_b.add(b.to);
    return box_a.overlaps(box_b);
  }
  return a0 * a1 <= 0 && b0 * b1 <= 0;
}

}  // namespace

double distance_units(Point point, const Segment& segment) {
  const double dx = static_cast<double>(segment.to.x) - segment.from.x;
  const double dy = static_cast<double>(segment.to.y) - segment.from.y;
  const double px = static_cast<double>(point.x) - segment.from.x;
  const double py = static_cast<double>(point.y) - segment.from.y;
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0.0;
  return std::hypot(px - t * dx, py - t * dy);
}

std::int64_t SegmentGrid::column(std::int64_t coordinate) const {
  const std::int64_t down = coordinate < 0 ? cell_ - 1 : 0;
  return (coordinate - down) / cell_;
}

SegmentGrid::Cell SegmentGrid::key(std::int64_t column, std::int64_t row) {
  return (static_cast<Cell>(static_cast<std::uint32_t>(column)) << 32) |
         static_cast<Cell>(static_cast<std::uint32_t>(row));
}

// Row by row: the columns that the line passes within each row, rounded outwards.
template <typename Visit>
bool SegmentGrid::walk(const Segment& line, const Visit& visit) const {
  const Segment up = line.from.y <= line.to.y ? line : Segment{line.to, line.from};
  const std::int64_t first = column(up.from.y), last = column(up.to.y);
  const double slope = up.to.y == up.from.y ? 0.0
                                            : (static_cast<double>(up.to.x) - up.from.x) /
                                                  (static_cast<double>(up.to.y) - up.from.y);
  const auto x_at = [&](std::int64_t y) {
    return static_cast<double>(up.from.x) + slope * static_cast<double>(y - up.from.y);
  };
  for (std::int64_t row = first; row <= last; ++row) {
    double x0 = up.from.x, x1 = up.to.x;
    if (row > first) x0 = x_at(row * cell_);
    if (row < last) x1 = x_at((row + 1) * cell_);
    const auto low = static_cast<std::int64_t>(std::floor(std::min(x0, x1))) - 1;
    const auto high = static_cast<std::int64_t>(std::ceil(std::max(x0, x1))) + 1;
    for (std::int64_t at = column(low); at <= column(high); ++at) {
      if (visit(key(at, row))) return true;
    }
  }
  return false;
}

void SegmentGrid::add(const Segment& segment) {
  const auto index = static_cast<std::uint32_t>(segments_.size());
  segments_.push_back(segment);
  walk(segment, [&](Cell cell) {
    cells_[cell].push_back(index);
    return false;
  });
}

void SegmentGrid::add(const Region& region) {
  for (const Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) add({ring[i], ring[(i + 1) % ring.size()]});
  }
}

bool SegmentGrid::any_within(Point point, Length reach) const {
  const std::int64_t r = reach.units();
  const auto limit = static_cast<double>(r);
  for (std::int64_t row = column(point.y - r); row <= column(point.y + r); ++row) {
    for (std::int64_t at = column(point.x - r); at <= column(point.x + r); ++at) {
      const auto found = cells_.find(key(at, row));
      if (found == cells_.end()) continue;
      for (const std::uint32_t index : found->second) {
        if (distance_units(point, segments_[index]) <= limit) return true;
      }
    }
  }
  return false;
}

bool SegmentGrid::crosses(const Segment& line) const {
  return walk(line, [&](Cell cell) {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return false;
    return std::any_of(found->second.begin(), found->second.end(),
                       [&](std::uint32_t index) { return touch(segments_[index], line); });
  });
}

}  // namespace core
