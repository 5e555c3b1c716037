// Rings cut at the nodes: chains between nodes, and their order around each node.
//
//        ╲ 2   1 ╱         Around a node the ends of its chains are sorted by direction, counter-
//         ╲     ╱          clockwise from due west (west itself first, then south, east, north):
//     0 ───  •  ─── 4      the sector before the first end holds the direction a hair north of
//           ╱ ╲            west, in which winding_ray.h looks.
//        5 ╱   ╲ 3
//
// Chains that lie on one another are straight from node to node, because a corner between would be
// a node. So they leave both nodes in the same direction and are neighbours there: a bundle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/booleans/contour_edges.h"  // ContourEdges
#include "core/booleans/snap_rounding.h"  // Passage, NodeIndex

namespace core {

using ChainIndex = std::uint32_t;

// Part of a ring from one of its passages to the next, in the ring's direction.
struct EdgeChain {
  NodeIndex start = 0;
  NodeIndex end = 0;
  EdgeIndex corner = 0;            // first corner between, if there is any
  std::uint32_t corner_count = 0;  // wraps from the ring's last corner to its first
  std::uint32_t ring = 0;
};

// 2 · chain for the chain's start, 2 · chain + 1 for its end.
using ChainEnd = std::uint32_t;

// An end of a chain, seen from the node at which it is.
struct Spoke {
  Point toward;
  ChainEnd end = 0;
};

class ChainGraph {
 public:
  // COSTS: O(passages · log(passages at a node)). Memory is kept for the next operation.
  void build(const ContourEdges& edges, const SnapRounding& snapped);

  [[nodiscard]] std::span<const EdgeChain> chains() const { return chains_; }
  [[nodiscard]] std::uint32_t node_count() const {
    return static_cast<std::uint32_t>(first_spoke_.size() - 1);
  }
  // In the order drawn above.
  [[nodiscard]] std::span<const Spoke> spokes(NodeIndex node) const {
    return {spokes_.data() + first_spoke_[node], spokes_.data() + first_spoke_[node + 1]};
  }
  [[nodiscard]] NodeIndex node_at(ChainEnd end) const {
    const EdgeChain& chain = chains_[end / 2];
    return end % 2 == 0 ? chain.start : chain.end;
  }
  [[nodiscard]] bool has_chains(std::uint32_t ring) const { return has_chains_[ring] != 0; }

 private:
  void cut_rings(const ContourEdges& edges, std::span<const Passage> passages);
  void place_spokes(const ContourEdges& edges, std::span<const Point> nodes);

  std::vector<EdgeChain> chains_;
  std::vector<std::uint8_t> has_chains_;    // by ring
  std::vector<std::uint32_t> first_spoke_;  // by node, into spokes_
  std::vector<Spoke> spokes_;
};

// The chain's corners, first to last.
template <typename Visit>
void for_corners(const EdgeChain& chain, const ContourEdges& edges, Visit visit) {
  const ContourRing& ring = edges.rings()[chain.ring];
  EdgeIndex corner = chain.corner;
  for (std::uint32_t i = 0; i < chain.corner_count; ++i, ++corner) {
    if (corner == ring.end) corner = ring.first;
    visit(edges.from(corner));
  }
}

// REQUIRES: i < chain.corner_count
[[nodiscard]] inline Point corner(const EdgeChain& chain, const ContourEdges& edges,
                                  std::uint32_t i) {
  const ContourRing& ring = edges.rings()[chain.ring];
  const EdgeIndex index = chain.corner + i;
  return edges.from(index < ring.end ? index : index - ring.size());
}

}  // namespace core
