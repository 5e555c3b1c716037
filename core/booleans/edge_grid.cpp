#include "core/booleans/edge_grid.h"

#include <cmath>
#include <cstdlib>

namespace core {
namespace {

constexpr std::uint64_t kCellsPerEdge = 2;
constexpr std::uint64_t kCellsMin = 16;
// An edge of mean length enters no more than about this many cells.
constexpr std::uint64_t kMeanEntriesMax = 8;
// So many entries to a cell, on the mean, mean that detail is crowded: cells are cut finer there.
constexpr std::uint64_t kCrowdMax = 24;

// Every point is at least two units away from the grid's rim.
constexpr std::int64_t kRim = 2;

std::uint64_t extent_of(std::int32_t low, std::int32_t high) {
  return static_cast<std::uint64_t>(std::int64_t{high} - low + 2 * kRim + 1);
}

}  // namespace

void EdgeGrid::choose_even_cells(const ContourEdges& edges) {
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
  const std::uint64_t width = extent_of(box.min.x, box.max.x);
  const std::uint64_t height = extent_of(box.min.y, box.max.y);
  const std::uint64_t cells_max = std::max(kCellsMin, kCellsPerEdge * count);
  std::uint32_t shift = 0;
  for (; shift < 30; ++shift) {
    const std::uint64_t cells = ((width >> shift) + 1) * ((height >> shift) + 1);
    if (cells <= cells_max && (length >> shift) <= kMeanEntriesMax * count) break;
  }
  columns_.set_even(box.min.x - kRim, width, shift);
  rows_.set_even(box.min.y - kRim, height, shift);
}

// As many columns as rows, both where the corners are.
void EdgeGrid::choose_crowded_cells(const ContourEdges& edges) {
  const Box& box = edges.box();
  const auto corners = [&](auto coordinate) {
    values_.clear();
    for (const ContourRing& ring : edges.rings()) {
      for (EdgeIndex e = ring.first; e < ring.end; ++e)
        values_.push_back(coordinate(edges.from(e)));
    }
    return std::span<const std::int32_t>(values_);
  };
  const auto wanted = static_cast<std::uint32_t>(std::sqrt(edges.index_end())) + 1;
  columns_.set_crowded(box.min.x - kRim, extent_of(box.min.x, box.max.x), wanted,
                       corners([](Point p) { return p.x; }));
  rows_.set_crowded(box.min.y - kRim, extent_of(box.min.y, box.max.y), wanted,
                    corners([](Point p) { return p.y; }));
}

void EdgeGrid::build(const ContourEdges& edges) {
  choose_even_cells(edges);
  place_edges(edges);
  const std::uint64_t even_crowd = crowd_;
  if (even_crowd <= kCrowdMax * entries_.size()) return;
  choose_crowded_cells(edges);
  place_edges(edges);
  if (crowd_ < even_crowd) return;
  choose_even_cells(edges);
  place_edges(edges);
}

void EdgeGrid::place_edges(const ContourEdges& edges) {
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
  crowd_ = 0;
  for (std::uint32_t& start : starts_) {
    crowd_ += std::uint64_t{start} * start;
    start = end += start;
  }
  entries_.resize(end);
  // From the last to the first, so that every cell's edges come out in ascending order.
  for (std::size_t i = count; i-- > 0;) {
    entries_[--starts_[placed_[i].cell]] = placed_[i].edge;
  }
}

}  // namespace core
