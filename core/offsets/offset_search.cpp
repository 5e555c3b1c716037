#include "core/offsets/offset_search.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr std::int32_t kChunkEdgesMax = 8;
// Chunks of a run at least this long hold no edge of another.
constexpr std::int32_t kLongRun = 4;
constexpr OffsetBox kEmptyBox{1e300, 1e300, -1e300, -1e300};

// Cells along one coordinate that [from, to] touches.
std::pair<std::int32_t, std::int32_t> cell_range(double from, double to, double cells_per_unit,
                                                 std::int32_t count) {
  const double most = count - 1;
  return {static_cast<std::int32_t>(std::clamp(from * cells_per_unit, 0.0, most)),
          static_cast<std::int32_t>(std::clamp(to * cells_per_unit, 0.0, most))};
}

bool starts_long_run(const std::vector<OffsetEdge>& edges, std::size_t index) {
  const std::size_t last = index + kLongRun - 1;
  return last < edges.size() && edges[last].run == edges[index].run;
}

}  // namespace

void OffsetSearch::prepare(const OffsetInput& contours, double deepest) {
  deepest_ = deepest;
  gather_chunks(contours);
  neighbours_.clear();
  neighbours_first_.assign(1, 0);
  if (chunks_.empty()) return;
  fill_grid(contours);
  seen_by_.assign(chunks_.size(), -1);
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    find_neighbours(contours, i);
    neighbours_first_.push_back(neighbours_.size());
  }
}

void OffsetSearch::gather_chunks(const OffsetInput& contours) {
  chunks_.clear();
  const auto& edges = contours.edges();
  double total_length = 0;
  for (const OffsetEdge& edge : edges) total_length += edge.length;
  // Boxes much larger than either what is asked for or the edges themselves would tell nothing.
  const double extent_max =
      std::max(8 * deepest_, 4 * total_length / static_cast<double>(edges.size() + 1));
  std::int32_t run_length = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const OffsetEdge& edge = edges[i];
    const auto index = static_cast<std::int32_t>(i);
    const bool same_run = i > 0 && edges[i - 1].run == edge.run;
    const std::int32_t run_before = same_run ? 0 : run_length;
    run_length = same_run ? run_length + 1 : 1;
    // A chunk's edges lie behind one another in memory, each ending where the next starts.
    const bool follows = i > 0 && edges[i - 1].end_corner == index;
    if (!follows || index - chunks_.back().first >= kChunkEdgesMax || run_before >= kLongRun ||
        (!same_run && starts_long_run(edges, i))) {
      start_chunk(contours, index);
      continue;
    }
    OffsetChunk& chunk = chunks_.back();
    OffsetBox box = chunk.box;
    box.add(edge.x + edge.dx, edge.y + edge.dy);
    if (box.max_x - box.min_x + box.max_y - box.min_y > extent_max) {
      start_chunk(contours, index);
      continue;
    }
    chunk.box = box;
    chunk.last = index + 1;
    if (edge.run != chunk.run) chunk.run = -1;
  }
}

void OffsetSearch::start_chunk(const OffsetInput& contours, std::int32_t index) {
  const OffsetEdge& edge = contours.edges()[static_cast<std::size_t>(index)];
  const OffsetEdge& before = contours.edges()[static_cast<std::size_t>(edge.previous)];
  OffsetBox box = kEmptyBox;
  box.add(edge.x, edge.y);
  box.add(edge.x + edge.dx, edge.y + edge.dy);
  const bool reflex = contours.corners()[static_cast<std::size_t>(index)].reflex;
  chunks_.push_back({box, index, index + 1, edge.run, reflex && before.run != edge.run});
}

void OffsetSearch::fill_grid(const OffsetInput& contours) {
  box_ = kEmptyBox;
  for (const OffsetChunk& chunk : chunks_) {
    box_.add(chunk.box.min_x, chunk.box.min_y);
    box_.add(chunk.box.max_x, chunk.box.max_y);
  }
  const double width = box_.max_x - box_.min_x, height = box_.max_y - box_.min_y;
  const double count = static_cast<double>(chunks_.size());
  // About one cell a chunk, none smaller than the depth; thin boxes are bounded by their length.
  const double cell = std::max({deepest_, std::sqrt(width * height / count),
                                std::max(width, height) / (4 * count + 16), 1.0});
  cells_per_unit_ = 1 / cell;
  columns_ = static_cast<std::int32_t>(width * cells_per_unit_) + 1;
  rows_ = static_cast<std::int32_t>(height * cells_per_unit_) + 1;

  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  cell_first_.assign(cells + 2, 0);
  for (const OffsetChunk& chunk : chunks_) {
    visit_cells(contours, chunk, chunk.box, 0,
                [&](std::size_t cell_index) { ++cell_first_[cell_index + 2]; });
  }
  for (std::size_t i = 2; i < cell_first_.size(); ++i) cell_first_[i] += cell_first_[i - 1];
  entries_.resize(static_cast<std::size_t>(cell_first_.back()));
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    visit_cells(contours, chunks_[i], chunks_[i].box, 0, [&](std::size_t cell_index) {
      entries_[static_cast<std::size_t>(cell_first_[cell_index + 1]++)] =
          static_cast<std::int32_t>(i);
    });
  }
}

// Calls visit(cell) for the cells within `margin` of the box, or, for a chunk of one long edge, of
// the edge: row by row, what the edge spans in that row widened by the margin.
template <typename Visit>
void OffsetSearch::visit_cells(const OffsetInput& contours, const OffsetChunk& chunk,
                               const OffsetBox& box, double margin, Visit&& visit) const {
  const auto [left, right] = cell_range(box.min_x - margin - box_.min_x,
                                        box.max_x + margin - box_.min_x, cells_per_unit_, columns_);
  const auto [bottom, top] = cell_range(box.min_y - margin - box_.min_y,
                                        box.max_y + margin - box_.min_y, cells_per_unit_, rows_);
  const OffsetEdge& edge = contours.edges()[static_cast<std::size_t>(chunk.first)];
  const bool banded =
      chunk.last - chunk.first == 1 && top - bottom > 1 && right - left > 1 && edge.dy != 0;
  const double slope = banded ? edge.dx / edge.dy : 0;
  // The raised box reaches up to the depth farther than the edge.
  const double reach = margin > 0 ? margin + deepest_ + 1 : 1;
  for (std::int32_t row = bottom; row <= top; ++row) {
    std::int32_t from = left, to = right;
    if (banded) {
      const double low = box_.min_y + row / cells_per_unit_ - reach;
      const double high = box_.min_y + (row + 1) / cells_per_unit_ + reach;
      const double x_low =
          edge.x + (std::clamp(low, chunk.box.min_y, chunk.box.max_y) - edge.y) * slope;
      const double x_high =
          edge.x + (std::clamp(high, chunk.box.min_y, chunk.box.max_y) - edge.y) * slope;
      const auto range =
          cell_range(std::min(x_low, x_high) - reach - box_.min_x,
                     std::max(x_low, x_high) + reach - box_.min_x, cells_per_unit_, columns_);
      from = std::max(from, range.first);
      to = std::min(to, range.second);
    }
    const auto row_first = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    for (std::int32_t column = from; column <= to; ++column) {
      visit(row_first + static_cast<std::size_t>(column));
    }
  }
}

OffsetBox OffsetSearch::raised_box(const OffsetInput& contours, const OffsetChunk& chunk) const {
  OffsetBox box = chunk.box;
  for (std::int32_t i = chunk.first; i < chunk.last; ++i) {
    const OffsetEdge& edge = contours.edges()[static_cast<std::size_t>(i)];
    const double ux = edge.dx * edge.inverse_length * deepest_;
    const double uy = edge.dy * edge.inverse_length * deepest_;
    box.add(edge.x - uy, edge.y + ux);
    box.add(edge.x + edge.dx - uy, edge.y + edge.dy + ux);
    const OffsetCorner& corner = contours.corners()[static_cast<std::size_t>(i)];
    if (!corner.reflex) continue;
    // The arc lies within the tangents at its ends, or about its corner.
    const double half = corner.half_tangent;
    if (half < 1) {
      box.add(edge.x - uy - half * ux, edge.y + ux - half * uy);
    } else {
      box.add(edge.x - deepest_, edge.y - deepest_);
      box.add(edge.x + deepest_, edge.y + deepest_);
    }
    const OffsetEdge& before = contours.edges()[static_cast<std::size_t>(edge.previous)];
    const double scale = before.inverse_length * deepest_;
    box.add(edge.x - before.dy * scale, edge.y + before.dx * scale);
  }
  return box;
}

void OffsetSearch::find_neighbours(const OffsetInput& contours, std::size_t chunk_index) {
  const OffsetChunk& chunk = chunks_[chunk_index];
  const OffsetBox raised = raised_box(contours, chunk);
  const double reach = deepest_ + 1;  // 1: more than any rounding
  const auto self = static_cast<std::int32_t>(chunk_index);
  const std::int32_t skipped_run = chunk.open ? -1 : chunk.run;
  seen_by_[chunk_index] = self;
  // Its own edges first: they are what trims most.
  if (skipped_run < 0) neighbours_.push_back(self);
  visit_cells(contours, chunk, raised, reach, [&](std::size_t cell) {
    const auto first = static_cast<std::size_t>(cell_first_[cell]);
    const auto last = static_cast<std::size_t>(cell_first_[cell + 1]);
    for (std::size_t i = first; i < last; ++i) {
      const std::int32_t other = entries_[i];
      const auto other_index = static_cast<std::size_t>(other);
      if (seen_by_[other_index] == self) continue;
      seen_by_[other_index] = self;
      const OffsetChunk& found = chunks_[other_index];
      if (skipped_run >= 0 && found.run == skipped_run) continue;
      if (raised.distance_squared(found.box) <= reach * reach) {
        neighbours_.push_back(other);
      }
    }
  });
}

}  // namespace core
