// Links boundary pieces to rings.
//
// A ring that comes back to a node is cut there into two, so that no ring touches itself at a
// node. A node that the boundary passes only once, and exactly straight on, is left out. Every
// ring starts at its least point (by x, then y), and rings are sorted by their first points. So
// the result depends neither on where the operands' rings started nor on the order of the
// operands.
#pragma once

#include <cstdint>
#include <vector>

#include "core/booleans/boundary_walk.h"  // BoundaryWalk
#include "core/booleans/chain_graph.h"    // ChainGraph

namespace core {

class RingTracer {
 public:
  // Appends to rings. COSTS: O(points written). Memory is kept for the next operation.
  void trace(const ContourEdges& edges, const SnapRounding& snapped, const ChainGraph& graph,
             const BoundaryWalk& walk, std::vector<Ring>& rings);

 private:
  void add_corners(const ContourEdges& edges, const ChainGraph& graph, BoundaryPiece piece);
  void cut_loop(NodeIndex node, std::vector<Ring>& rings);
  void drop_straight_nodes(std::size_t start);

  std::vector<Point> points_;  // of the ring that is being traced
  std::vector<NodeIndex> path_;
  std::vector<std::uint32_t> index_;   // by node: its index in points_ + 1 while it is on the path
  std::vector<std::uint8_t> traced_;   // by piece
  std::vector<std::uint32_t> simple_;  // ascending: indices in points_ of nodes passed only once
};

enum class Turned { kNo, kYes };

// The ring with its least point first; with Turned::kYes in the other direction.
[[nodiscard]] Ring canonical_ring(const Point* first, const Point* end, Turned turned);

// The order of rings: by their first points, then by their second ones. No two rings of a clean
// region have both in common.
[[nodiscard]] bool ring_before(const Ring& a, const Ring& b);
void sort_rings(std::vector<Ring>& rings);

}  // namespace core
