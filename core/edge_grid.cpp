#include "core/edge_grid.h"

#include <cstdlib>

namespace core {
namespace {

constexpr std::uint64_t kCellsPerEdge = 2;
constexpr std::uint64_t kCellsMin = 16;
// An edge of mean length enters no more than about this many cells.
constexpr std::uint64_t kMeanEntriesMax = 8;

}  // namespace

void EdgeGrid::choose_cells(const ContourEdges& edges) {
  std::uint64_t length = 0, count = 0;
  for (const ContourRing& ring : edges.rings()) {
    for (EdgeIndex e = ring.first; e < ring.end; ++e) {
      const Point a = edges.from(e), b = edges.to(e);
      length += static_cast<std::uint64_t>(std::abs(std::int64_t{b.x} - a.x) +
                                           std::abs(std::int64_t{b.y} - a.y));
    }
    count += ring.size();
  }
  const Box& box = edges.box();
  // Every point is at least two units away from the grid's rim.
  origin_x_ = std::int64_t{box.min.x} - 2;
  origin_y_ = std::int64_t{box.min.y} - 2;
  const auto width = static_cast<std::uint64_t>(box.max.x + std::int64_t{3} - origin_x_);
  const auto height = static_cast<std::uint64_t>(box.max.y + std::int64_t{3} - origin_y_);
  const std::uint64_t cells_max = std::max(kCellsMin, kCellsPerEdge * count);
  for (shift_ = 0; shift_ < 30; ++shift_) {
    const std::uint64_t cells = ((width >> shift_) + 1) * ((height >> shift_) + 1);
    if (cells <= cells_max && (length >> shift_) <= kMeanEntriesMax * count) break;
  }
  columns_ = static_cast<std::uint32_t>(width >> shift_) + 1;
  rows_ = static_cast<std::uint32_t>(height >> shift_) + 1;
}

void EdgeGrid::build(const ContourEdges& edges) {
  choose_cells(edges);
  starts_.assign(std::size_t{cell_count()} + 1, 0);
  std::size_t count = 0;
  for (const ContourRing& ring : edges.rings()) {
    for (EdgeIndex e = ring.first; e < ring.end; ++e) {
      for_cells(edges.from(e), edges.to(e), [&](std::uint32_t cell) {
        ++starts_[cell];
        if (count == placed_.size()) placed_.resize(2 * count + 64);
        placed_[count++] = {cell, e};
      });
    }
  }
  std::uint32_t end = 0;
  for (std::uint32_t& start : starts_) start = end += start;
  entries_.resize(end);
  // From the last to the first, so that every cell's edges come out in ascending order.
  for (std::size_t i = count; i-- > 0;) {
    entries_[--starts_[placed_[i].cell]] = placed_[i].edge;
  }
}

}  // namespace core
