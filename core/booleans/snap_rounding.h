// Makes edges meet only at their ends, on the grid, without any of them crossing another on the
// way.
//
//      \   /              \   /       A crossing becomes a node: the middle of its pixel.
//       \ /                \ /        Every edge that passes a node's pixel is bent to run
//        ×        ->        •         through the node.
//       / \                / \        .
//
// Why no new crossing can arise: snap rounding (Guibas and Marimont, "Rounding arrangements
// dynamically", 1998, theorem 2; Hobby, "Practical segment intersection with finite precision
// output", 1999). Let the pixels of all crossings and of all end points be hot, and bend every edge
// to run through the middles of the hot pixels that it passes. Then edges may come to lie on one
// another, but no edge passes over a node or over another edge: the rounded drawing is the limit of
// one in which pixels shrink to their middles and nothing crosses.
//
// Here only some end points become nodes. An edge is bent when it passes a node's pixel beside its
// middle. A node is
//   - the pixel of every crossing, and every end point that lies exactly on an edge it may meet;
//   - every end point whose pixel is passed by a bent edge that does not end there;
//   - an end of a bent edge whose pixel a third edge passes, bent or not, or that has become the
//     tip of a spur: both of its edges pass the same node next;
// until nothing changes.
//
// That is enough to keep edges from crossing. Every end point is hot for the bent edges (it is a
// node if they pass its pixel, and where they end nothing moves), so theorem 2 holds for them: they
// don't cross, nor pass over an end of any edge. The other edges stay where they are and cross each
// other nowhere. Now let an unbent edge u cross the new course of a bent edge, but not its old one.
// Then u enters the sliver between the two. It cannot leave through the old course (there is no
// crossing), nor along the sliver's short sides (they lie in hot pixels, which u passes only
// through the middle), nor through the new course again (both are straight). So u ends inside, at
// an end point that the bent edge has passed over, which was excluded.
//
// It is also enough to find edges that lie on one another by their ends: a corner that is no node
// has no edges near it but its own two if one of these is bent, and the two don't fold.
//
// Far from crossings nothing is done, which saves most of the time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/booleans/contour_edges.h"  // ContourEdges, EdgeIndex
#include "core/booleans/edge_tree.h"      // EdgeTree

namespace core {

using NodeIndex = std::uint32_t;

// An edge runs through a node.
struct Passage {
  EdgeIndex edge = 0;
  // Steps |dx| + |dy| from the edge's first point; 0 is that point itself. An edge's last point
  // belongs to the next edge.
  std::uint32_t along = 0;
  NodeIndex node = 0;
};

// Which edges are tried against which.
enum class Meetings {
  kAcrossOperands,  // each operand is clean, so its own edges don't cross
  kAll,
};

class SnapRounding {
 public:
  // COSTS: O(edges + pairs of near edges + (nodes + bent edges) · (log edges + near edges)).
  // Memory is kept for the next operation.
  void run(const ContourEdges& edges, const EdgeTree& tree, Meetings meetings);

  // A node at every ring's first point, if the ring has none yet. They touch no other edge.
  void add_node_to_rings_without(const ContourEdges& edges);

  [[nodiscard]] std::span<const Point> nodes() const { return nodes_; }
  // Ascending by edge, then along it; no two alike.
  [[nodiscard]] std::span<const Passage> passages() const { return passages_; }
  // Whether the edge has left its straight course.
  [[nodiscard]] bool bent(EdgeIndex edge) const { return bent_[edge] != 0; }
  // Those of one edge. COSTS: O(log passages)
  [[nodiscard]] std::span<const Passage> passages_of(EdgeIndex edge) const;

 private:
  [[nodiscard]] static bool neighbours(const ContourEdges& edges, EdgeIndex e, EdgeIndex f);
  void meet(const ContourEdges& edges, EdgeIndex e, EdgeIndex f);
  void meet_at_corner(const ContourEdges& edges, EdgeIndex e, EdgeIndex f);
  void add_node(Point p);
  void grow_table();
  std::size_t find_passages(const ContourEdges& edges, const EdgeTree& tree, std::size_t first);
  void bend_edges(const ContourEdges& edges, const EdgeTree& tree);
  void bend(const ContourEdges& edges, EdgeIndex edge, EdgeIndex other);
  void sort_passages();
  void find_spurs(const ContourEdges& edges);
  void find_coinciding_ring(const ContourEdges& edges);

  std::vector<Point> nodes_;
  std::vector<NodeIndex> table_;  // by hash of the point: node + 1, or 0
  std::vector<Passage> passages_;
  std::vector<Passage> by_edge_;             // room to sort them
  std::vector<std::uint32_t> next_passage_;  // by edge
  std::vector<std::uint8_t> bent_;           // by edge
  std::vector<EdgeIndex> newly_bent_;
  std::vector<std::uint8_t> runs_along_;  // by ring: has a corner on a run that another shares
};

}  // namespace core
