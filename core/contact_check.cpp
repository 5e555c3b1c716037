#include "core/contact_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/region.h"  // doubled_area_units

namespace core {
namespace {

struct Edge {
  Point from;
  Point to;
  std::uint32_t previous;  // of the same ring
  std::uint32_t next;
};

int sign(std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

Box box_of(const Edge& edge) {
  Box box;
  box.add(edge.from);
  box.add(edge.to);
  return box;
}

// Closed segments with a point in common.
bool meet(const Edge& a, const Edge& b) {
  if (!box_of(a).overlaps(box_of(b))) return false;
  const int b_from = sign(cross(a.from, a.to, b.from)), b_to = sign(cross(a.from, a.to, b.to));
  if (b_from * b_to > 0) return false;
  const int a_from = sign(cross(b.from, b.to, a.from)), a_to = sign(cross(b.from, b.to, a.to));
  // All four zero: on one line, where the overlapping boxes decide.
  return a_from * a_to <= 0;
}

// For edges a -> b -> c: whether the second runs back over the first.
bool folds_back(Point a, Point b, Point c) {
  if (cross(a, b, c) != 0) return false;
  const std::int64_t dot = (std::int64_t{b.x} - a.x) * (std::int64_t{c.x} - b.x) +
                           (std::int64_t{b.y} - a.y) * (std::int64_t{c.y} - b.y);
  return dot < 0;
}

std::vector<Edge> edges_of(const std::vector<Ring>& rings) {
  std::vector<Edge> edges;
  for (const Ring& ring : rings) {
    const auto first = static_cast<std::uint32_t>(edges.size());
    const auto size = static_cast<std::uint32_t>(ring.size());
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint32_t next = (i + 1) % size, previous = (i + size - 1) % size;
      edges.push_back({ring[i], ring[next], first + previous, first + next});
    }
  }
  return edges;
}

class EdgeGrid {
 public:
  // REQUIRES: edges is not empty, and outlives the grid.
  explicit EdgeGrid(const std::vector<Edge>& edges) : edges_(edges) {
    for (const Edge& edge : edges) box_.add(edge.from);
    const double width = static_cast<double>(box_.max.x) - box_.min.x + 1;
    const double height = static_cast<double>(box_.max.y) - box_.min.y + 1;
    const double count = static_cast<double>(edges.size());
    cell_ = std::max({std::sqrt(width * height / count), width / count, height / count, 1.0});
    columns_ = static_cast<std::size_t>(width / cell_) + 1;
    rows_ = static_cast<std::size_t>(height / cell_) + 1;
    starts_.assign(columns_ * rows_ + 1, 0);
    for (const Edge& edge : edges_) {
      for_cells(edge, [&](std::size_t cell) { ++starts_[cell + 1]; });
    }
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    members_.resize(starts_.back());
    std::vector<std::uint32_t> fill(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      for_cells(edges_[i], [&](std::size_t cell) { members_[fill[cell]++] = i; });
    }
  }

  [[nodiscard]] bool any_contact() const {
    for (std::size_t cell = 0; cell + 1 < starts_.size(); ++cell) {
      for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
        const Edge& a = edges_[members_[i]];
        for (std::uint32_t j = i + 1; j < starts_[cell + 1]; ++j) {
          const std::uint32_t other = members_[j];
          if (other == a.previous || other == a.next) continue;
          if (meet(a, edges_[other])) return true;
        }
      }
    }
    return false;
  }

  // Calls visit(edge, corner) for each corner that lies within an edge; may repeat itself.
  template <typename Visit>
  void for_touches(Visit visit) const {
    for (std::size_t cell = 0; cell + 1 < starts_.size(); ++cell) {
      for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
        const Edge& edge = edges_[members_[i]];
        const Box box = box_of(edge);
        for (std::uint32_t j = starts_[cell]; j < starts_[cell + 1]; ++j) {
          const Point corner = edges_[members_[j]].from;
          if (corner == edge.from || corner == edge.to || !box.overlaps({corner, corner})) continue;
          if (cross(edge.from, edge.to, corner) == 0) visit(members_[i], corner);
        }
      }
    }
  }

 private:
  // Every cell that the edge may reach, row by row, a unit wide of it on both sides.
  template <typename Visit>
  void for_cells(const Edge& edge, Visit visit) const {
    const Point low = edge.from.y <= edge.to.y ? edge.from : edge.to;
    const Point high = edge.from.y <= edge.to.y ? edge.to : edge.from;
    const double x0 = static_cast<double>(low.x) - box_.min.x;
    const double y0 = static_cast<double>(low.y) - box_.min.y;
    const double x1 = static_cast<double>(high.x) - box_.min.x;
    const double y1 = static_cast<double>(high.y) - box_.min.y;
    const double slope = y1 > y0 ? (x1 - x0) / (y1 - y0) : 0;
    const std::size_t last_row = index(y1 + 1, rows_);
    for (std::size_t row = index(y0 - 1, rows_); row <= last_row; ++row) {
      double left = std::min(x0, x1), right = std::max(x0, x1);
      if (y1 > y0) {
        const double bottom = static_cast<double>(row) * cell_, top = bottom + cell_;
        const double at_bottom = x0 + slope * (std::max(bottom - 1, y0) - y0);
        const double at_top = x0 + slope * (std::min(top + 1, y1) - y0);
        left = std::max(left, std::min(at_bottom, at_top));
        right = std::min(right, std::max(at_bottom, at_top));
      }
      const std::size_t last_column = index(right + 1, columns_);
      for (std::size_t column = index(left - 1, columns_); column <= last_column; ++column) {
        visit(row * columns_ + column);
      }
    }
  }

  [[nodiscard]] std::size_t index(double offset, std::size_t count) const {
    if (offset <= 0) return 0;
    return std::min(static_cast<std::size_t>(offset / cell_), count - 1);
  }

  const std::vector<Edge>& edges_;
  Box box_;
  double cell_ = 1;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::uint32_t> starts_;  // by cell, into members_
  std::vector<std::uint32_t> members_;
};

// Of a point that lies on no edge of the ring.
int winding_number(const Ring& ring, Point p) {
  int winding = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (a.y <= p.y && b.y > p.y && cross(a, b, p) > 0) ++winding;
    if (b.y <= p.y && a.y > p.y && cross(a, b, p) < 0) --winding;
  }
  return winding;
}

// For rings without contacts: outer contours stand outside all others or in a hole, and turn
// counter-clockwise; holes the other way.
bool well_nested(const std::vector<Ring>& rings) {
  std::vector<Box> boxes(rings.size());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (const Point p : rings[i]) boxes[i].add(p);
  }
  for (std::size_t i = 0; i < rings.size(); ++i) {
    int around = 0;
    for (std::size_t j = 0; j < rings.size(); ++j) {
      if (i != j && boxes[j].overlaps(boxes[i])) around += winding_number(rings[j], rings[i][0]);
    }
    const double area = doubled_area_units(rings[i]);
    if (area == 0 || around != (area > 0 ? 0 : 1)) return false;
  }
  return true;
}

}  // namespace

bool surely_clean(const std::vector<Ring>& rings) {
  for (const Ring& ring : rings) {
    if (ring.size() < 3) return false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
      if (a == b || folds_back(a, b, c)) return false;
    }
  }
  if (rings.empty()) return true;
  const std::vector<Edge> edges = edges_of(rings);
  return !EdgeGrid(edges).any_contact() && well_nested(rings);
}

std::vector<Ring> split_at_touches(const std::vector<Ring>& rings) {
  if (rings.empty()) return rings;
  const std::vector<Edge> edges = edges_of(rings);
  std::vector<std::pair<std::uint32_t, Point>> touches;
  EdgeGrid(edges).for_touches(
      [&](std::uint32_t edge, Point corner) { touches.emplace_back(edge, corner); });
  if (touches.empty()) return rings;
  std::sort(touches.begin(), touches.end(), [&](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    // Points are ordered along any line that they lie on.
    return edges[a.first].from < edges[a.first].to ? a.second < b.second : b.second < a.second;
  });
  touches.erase(std::unique(touches.begin(), touches.end()), touches.end());
  std::vector<Ring> result;
  auto touch = touches.begin();
  std::uint32_t edge = 0;
  for (const Ring& ring : rings) {
    Ring split;
    for (const Point p : ring) {
      split.push_back(p);
      for (; touch != touches.end() && touch->first == edge; ++touch)
        split.push_back(touch->second);
      ++edge;
    }
    result.push_back(std::move(split));
  }
  return result;
}

}  // namespace core
