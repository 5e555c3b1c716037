#include "core/offsets/offset_search.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr std::int32_t kChunkEdgesMax = 8;
// Chunks of a run at least this long hold no edge of another.
constexpr std::int32_t kLongRun = 4;
constexpr OffsetBox kEmptyBox{1e300, 1e300, -1e300, -1e300};

// A part's box is at least so many mean edges wide: smaller ones would be too many.
constexpr double kPartInEdges = 2;

// Boxes of integers: exact where the numbers are whole, as edges' ends are, else a unit wider.
Box grown(const OffsetBox& box, double by) {
  const auto down = [&](double at) { return static_cast<std::int32_t>(at - by) - 1; };
  const auto up = [&](double at) { return static_cast<std::int32_t>(at + by) + 1; };
  return {{down(box.min_x), down(box.min_y)}, {up(box.max_x), up(box.max_y)}};
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
  plant_tree(contours);
  seen_by_.assign(chunks_.size(), -1);
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    find_neighbours(contours, i);
    neighbours_first_.push_back(neighbours_.size());
  }
}

void OffsetSearch::gather_chunks(const OffsetInput& contours) {
  chunks_.clear();
  contour_first_.clear();
  const auto& edges = contours.edges();
  double total_length = 0;
  for (const OffsetEdge& edge : edges) total_length += edge.length;
  // Boxes much larger than either what is asked for or the edges themselves would tell nothing.
  const double extent_max =
      std::max(8 * deepest_, 4 * total_length / static_cast<double>(edges.size() + 1));
  part_max_ =
      std::max(2 * deepest_, kPartInEdges * total_length / static_cast<double>(edges.size() + 1));
  std::int32_t run_length = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const OffsetEdge& edge = edges[i];
    const auto index = static_cast<std::int32_t>(i);
    const bool same_run = i > 0 && edges[i - 1].run == edge.run;
    const std::int32_t run_before = same_run ? 0 : run_length;
    run_length = same_run ? run_length + 1 : 1;
    // A chunk's edges lie behind one another in memory, each ending where the next starts.
    const bool follows = i > 0 && edges[i - 1].end_corner == index;
    if (!follows) contour_first_.push_back(chunks_.size());
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

void OffsetSearch::plant_tree(const OffsetInput& contours) {
  tree_.clear();
  const auto first_of = [&](std::uint32_t contour) {
    const OffsetChunk& chunk = chunks_[contour_first_[contour]];
    const OffsetEdge& edge = contours.edges()[static_cast<std::size_t>(chunk.first)];
    return Point{static_cast<std::int32_t>(edge.x), static_cast<std::int32_t>(edge.y)};
  };
  for (const std::uint32_t contour : order_.near_by_near(contour_first_.size(), first_of)) {
    const std::size_t end =
        contour + 1 < contour_first_.size() ? contour_first_[contour + 1] : chunks_.size();
    tree_.keep_together(end - contour_first_[contour]);
    for (std::size_t i = contour_first_[contour]; i < end; ++i) {
      for_parts(contours, chunks_[i], [&](const OffsetBox& part) {
        tree_.add(grown(part, 0), static_cast<std::uint32_t>(i));
      });
    }
  }
  tree_.finish();
}

std::int32_t OffsetSearch::part_count(const OffsetChunk& chunk) const {
  if (chunk.last - chunk.first > 1) return 1;
  const double shorter =
      std::min(chunk.box.max_x - chunk.box.min_x, chunk.box.max_y - chunk.box.min_y);
  return static_cast<std::int32_t>(shorter / part_max_) + 1;
}

// visit(OffsetBox) for boxes that hold the chunk's edges.
template <typename Visit>
void OffsetSearch::for_parts(const OffsetInput& contours, const OffsetChunk& chunk,
                             Visit visit) const {
  const std::int32_t count = part_count(chunk);
  if (count == 1) return visit(chunk.box);
  const OffsetEdge& edge = contours.edges()[static_cast<std::size_t>(chunk.first)];
  double x = edge.x, y = edge.y;
  for (std::int32_t i = 1; i <= count; ++i) {
    OffsetBox part{x, y, x, y};
    x = edge.x + edge.dx * i / count;
    y = edge.y + edge.dy * i / count;
    part.add(x, y);
    visit(part);
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
  const auto search = [&](const Box& box) {
    tree_.for_items_in(box, [&](std::uint32_t other) {
      if (seen_by_[other] == self) return;
      seen_by_[other] = self;
      const OffsetChunk& found = chunks_[other];
      if (skipped_run >= 0 && found.run == skipped_run) return;
      if (raised.distance_squared(found.box) > reach * reach) return;
      neighbours_.push_back(static_cast<std::int32_t>(other));
    });
  };
  if (part_count(chunk) == 1) {
    search(grown(raised, reach));
  } else {
    // What a part raises lies within the depth of it.
    for_parts(contours, chunk,
              [&](const OffsetBox& part) { search(grown(part, deepest_ + reach)); });
  }
}

}  // namespace core
