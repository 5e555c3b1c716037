// Finds edges that are near: a uniform grid of square cells over all edges of an operation.
//
// There are about two cells an edge. Contours are lines on an area, so they fill few of the cells,
// and few of them meet in one. Where most edges crowd in few cells all the same, the grid is made
// again, with finer cells there (grid_axis.h).
//
// Every edge is entered in all cells that come within a unit of it. So it is found from the cell
// of any point nearer than that, even after rounding has bent it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/booleans/contour_edges.h"  // ContourEdges, EdgeIndex
#include "core/booleans/grid_axis.h"      // GridAxis

namespace core {

class EdgeGrid {
 public:
  // COSTS: O(edges + entries); an edge has more than a few entries only if it is many times longer
  // than the mean. Memory is kept for the next operation.
  void build(const ContourEdges& edges);

  [[nodiscard]] std::uint32_t columns() const { return columns_.count(); }
  [[nodiscard]] std::uint32_t cell_count() const { return columns_.count() * rows_.count(); }
  [[nodiscard]] std::uint32_t cell_of(Point p) const {
    return rows_.index(p.y) * columns_.count() + columns_.index(p.x);
  }
  // The x at which a column of cells starts.
  [[nodiscard]] std::int32_t column_west(std::uint32_t column) const {
    return static_cast<std::int32_t>(columns_.start(column));
  }
  // In ascending order.
  [[nodiscard]] std::span<const EdgeIndex> edges_in(std::uint32_t cell) const {
    return {entries_.data() + starts_[cell], entries_.data() + starts_[cell + 1]};
  }

  // Calls visit(cell) for the cells in which the edge from a to b is entered.
  template <typename Visit>
  void for_cells(Point a, Point b, Visit visit) const;

 private:
  void choose_even_cells(const ContourEdges& edges);
  void choose_crowded_cells(const ContourEdges& edges);
  void place_edges(const ContourEdges& edges);
  template <typename Visit>
  void for_cells_by_row(Point a, Point b, Visit visit) const;

  GridAxis columns_;
  GridAxis rows_;
  std::vector<std::uint32_t> starts_;  // by cell, into entries_
  std::vector<EdgeIndex> entries_;
  struct Placed {
    std::uint32_t cell;
    EdgeIndex edge;
  };
  std::vector<Placed> placed_;  // room to work; only grows
  std::vector<std::int32_t> values_;
  std::uint64_t crowd_ = 0;  // pairs of edges in common cells, an edge and itself included
};

// Implementation details follow.

template <typename Visit>
void EdgeGrid::for_cells(Point a, Point b, Visit visit) const {
  const std::uint32_t left = columns_.index(std::int64_t{std::min(a.x, b.x)} - 1);
  const std::uint32_t right = columns_.index(std::int64_t{std::max(a.x, b.x)} + 1);
  const std::uint32_t bottom = rows_.index(std::int64_t{std::min(a.y, b.y)} - 1);
  const std::uint32_t top = rows_.index(std::int64_t{std::max(a.y, b.y)} + 1);
  const std::uint32_t columns = columns_.count();
  if (left == right && bottom == top) return visit(bottom * columns + left);
  if (right - left > 1 && a.y != b.y) return for_cells_by_row(a, b, visit);
  for (std::uint32_t row = bottom; row <= top; ++row) {
    for (std::uint32_t column = left; column <= right; ++column) visit(row * columns + column);
  }
}

template <typename Visit>
void EdgeGrid::for_cells_by_row(Point a, Point b, Visit visit) const {
  if (b.y < a.y) std::swap(a, b);
  const double slope = (static_cast<double>(b.x) - a.x) / (static_cast<double>(b.y) - a.y);
  const std::int64_t x_low = std::min(a.x, b.x), x_high = std::max(a.x, b.x);
  const std::uint32_t top = rows_.index(std::int64_t{b.y} + 1);
  for (std::uint32_t row = rows_.index(std::int64_t{a.y} - 1); row <= top; ++row) {
    const std::int64_t y0 = std::clamp<std::int64_t>(rows_.start(row) - 1, a.y, b.y);
    const std::int64_t y1 = std::clamp<std::int64_t>(rows_.start(row + 1) + 1, a.y, b.y);
    const auto x0 = a.x + static_cast<std::int64_t>(slope * static_cast<double>(y0 - a.y));
    const auto x1 = a.x + static_cast<std::int64_t>(slope * static_cast<double>(y1 - a.y));
    // The conversion cut off less than one unit.
    const std::int64_t low = std::max(std::min(x0, x1) - 1, x_low) - 1;
    const std::int64_t high = std::min(std::max(x0, x1) + 1, x_high) + 1;
    const std::uint32_t right = columns_.index(high);
    for (std::uint32_t column = columns_.index(low); column <= right; ++column) {
      visit(row * columns_.count() + column);
    }
  }
}

}  // namespace core
