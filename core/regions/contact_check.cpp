#include "core/regions/contact_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/regions/clear_contours.h"  // keep_clear

namespace core {
namespace {

class EdgeGrid {
 public:
  // REQUIRES: edges is not empty, and outlives the grid.
  explicit EdgeGrid(const std::vector<Segment>& edges) : edges_(edges) {
    for (const Segment& edge : edges) box_.add(edge.from);
    const double width = static_cast<double>(box_.max.x) - box_.min.x + 1;
    const double height = static_cast<double>(box_.max.y) - box_.min.y + 1;
    const double count = static_cast<double>(edges.size());
    cell_ = std::max({std::sqrt(width * height / count), width / count, height / count, 1.0});
    columns_ = static_cast<std::size_t>(width / cell_) + 1;
    rows_ = static_cast<std::size_t>(height / cell_) + 1;
    starts_.assign(columns_ * rows_ + 1, 0);
    for (const Segment& edge : edges_) {
      for_cells(edge, [&](std::size_t cell) { ++starts_[cell + 1]; });
    }
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    members_.resize(starts_.back());
    std::vector<std::uint32_t> fill(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      for_cells(edges_[i], [&](std::size_t cell) { members_[fill[cell]++] = i; });
    }
  }

  // Calls visit(edge, corner) for each corner that lies within an edge; may repeat itself.
  template <typename Visit>
  void for_touches(Visit visit) const {
    for (std::size_t cell = 0; cell + 1 < starts_.size(); ++cell) {
      for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
        const Segment& edge = edges_[members_[i]];
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
  void for_cells(const Segment& edge, Visit visit) const {
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

  const std::vector<Segment>& edges_;
  Box box_;
  double cell_ = 1;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::uint32_t> starts_;  // by cell, into members_
  std::vector<std::uint32_t> members_;
};

}  // namespace

bool surely_clean(const std::vector<Ring>& rings) { return keep_clear(rings); }

std::vector<Ring> split_at_touches(const std::vector<Ring>& rings) {
  if (rings.empty()) return rings;
  const std::vector<Segment> edges = edges_of(rings);
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
