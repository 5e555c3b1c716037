#include "core/booleans/ring_tracer.h"

#include <algorithm>

#include "core/check.h"  // RIND_CHECK

namespace core {
namespace {

bool ahead(BoundaryPiece piece) { return piece % 2 == 0; }

}  // namespace

Ring canonical_ring(const Point* first, const Point* end, Turned turned) {
  const Point* least = std::min_element(first, end);
  Ring ring;
  ring.reserve(static_cast<std::size_t>(end - first));
  if (turned == Turned::kNo) {
    ring.insert(ring.end(), least, end);
    ring.insert(ring.end(), first, least);
  } else {
    ring.insert(ring.end(), std::make_reverse_iterator(least + 1),
                std::make_reverse_iterator(first));
    ring.insert(ring.end(), std::make_reverse_iterator(end), std::make_reverse_iterator(least + 1));
  }
  return ring;
}

bool ring_before(const Ring& a, const Ring& b) { return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1]; }

void sort_rings(std::vector<Ring>& rings) { std::sort(rings.begin(), rings.end(), ring_before); }

void RingTracer::trace(const ContourEdges& edges, const SnapRounding& snapped,
                       const ChainGraph& graph, const BoundaryWalk& walk,
                       std::vector<Ring>& rings) {
  index_.assign(graph.node_count(), 0);
  traced_.assign(2 * graph.chains().size(), 0);
  for (const BoundaryPiece first : walk.pieces()) {
    if (traced_[first] != 0) continue;
    points_.clear();
    path_.clear();
    simple_.clear();
    BoundaryPiece piece = first;
    do {
      RIND_CHECK(piece != kNoPiece && traced_[piece] == 0);
      traced_[piece] = 1;
      const NodeIndex node = graph.node_at(piece);
      if (index_[node] != 0) cut_loop(node, rings);
      if (walk.leaving(node) == 1) simple_.push_back(static_cast<std::uint32_t>(points_.size()));
      path_.push_back(node);
      points_.push_back(snapped.nodes()[node]);
      index_[node] = static_cast<std::uint32_t>(points_.size());
      add_corners(edges, graph, piece);
      piece = walk.next(piece);
    } while (piece != first);
    cut_loop(graph.node_at(first), rings);
  }
}

void RingTracer::add_corners(const ContourEdges& edges, const ChainGraph& graph,
                             BoundaryPiece piece) {
  const std::size_t start = points_.size();
  for_corners(graph.chains()[piece / 2], edges, [&](Point p) { points_.push_back(p); });
  if (!ahead(piece)) {
    std::reverse(points_.begin() + static_cast<std::ptrdiff_t>(start), points_.end());
  }
}

// Everything since the path was at the node becomes a ring.
void RingTracer::cut_loop(NodeIndex node, std::vector<Ring>& rings) {
  const std::size_t start = index_[node] - 1;
  drop_straight_nodes(start);
  rings.push_back(
      canonical_ring(points_.data() + start, points_.data() + points_.size(), Turned::kNo));
  points_.resize(start);
  for (bool done = false; !done; path_.pop_back()) {
    done = path_.back() == node;
    index_[path_.back()] = 0;
  }
}

// Nodes at which the boundary goes straight on and nothing else leaves: what made them is gone.
void RingTracer::drop_straight_nodes(std::size_t start) {
  std::size_t first = simple_.size();
  while (first > 0 && simple_[first - 1] >= start) --first;
  if (first == simple_.size()) return;
  std::size_t kept = start, next = first;
  for (std::size_t i = start; i < points_.size(); ++i) {
    if (next < simple_.size() && simple_[next] == i) {
      ++next;
      const Point before = kept > start ? points_[kept - 1] : points_.back();
      const Point after = points_[i + 1 < points_.size() ? i + 1 : start];
      if (cross(before, points_[i], after) == 0) continue;
    }
    points_[kept++] = points_[i];
  }
  points_.resize(kept);
  simple_.resize(first);
}

}  // namespace core
