// Finds the chains that separate inside from outside, and how they follow one another.
//
// Along a chain, the winding number on either side stays the same. Around a node, it changes from
// sector to sector by the weights of the chains between. So one ray for each connected piece of
// the graph gives all winding numbers. At a node, the boundary comes in on one bundle and leaves
// on the next one clockwise, with the inside between the two. That keeps apart what touches in a
// point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/booleans/chain_graph.h"   // ChainGraph
#include "core/booleans/winding_ray.h"   // WindingRay
#include "core/booleans/winding_rule.h"  // WindingRule

namespace core {

// 2 · chain for the chain as it runs, 2 · chain + 1 for its reverse. The inside is on its left.
using BoundaryPiece = std::uint32_t;
inline constexpr BoundaryPiece kNoPiece = UINT32_MAX;

class BoundaryWalk {
 public:
  // False: edges cross between nodes, so that there is no closed boundary. That happens only when
  // an operand was said to be clean and is not.
  // COSTS: O(chains + rays). Memory is kept for the next operation.
  [[nodiscard]] bool run(const ContourEdges& edges, const SnapRounding& snapped,
                         const ChainGraph& graph, WindingRay& ray, const WindingRule& rule,
                         bool operands_clean);

  // Each once, in an order that depends on the operands alone. Of a bundle, the first chain stands
  // for all.
  [[nodiscard]] std::span<const BoundaryPiece> pieces() const { return pieces_; }
  [[nodiscard]] BoundaryPiece next(BoundaryPiece piece) const { return next_[piece]; }
  // The lowest winding number beside any chain, or 0.
  [[nodiscard]] std::int32_t least_winding() const { return least_winding_; }
  // How many pieces leave the node.
  [[nodiscard]] std::uint32_t leaving(NodeIndex node) const { return leaving_[node]; }

 private:
  // A chain end whose right side is known: clockwise of it, seen from its node.
  struct Known {
    ChainEnd end;
    std::int32_t winding;
  };

  [[nodiscard]] std::int32_t change_at(const ContourEdges& edges, const ChainGraph& graph,
                                       ChainEnd end) const;
  [[nodiscard]] bool start_at_corner(const ContourEdges& edges, const ChainGraph& graph,
                                     NodeIndex node, WindingRay& ray);
  void walk_from(const ContourEdges& edges, const ChainGraph& graph, NodeIndex node,
                 std::int32_t winding, const WindingRule& rule);
  [[nodiscard]] bool spread(const ContourEdges& edges, const ChainGraph& graph,
                            const WindingRule& rule);

  std::vector<BoundaryPiece> pieces_;
  std::vector<BoundaryPiece> next_;     // by piece
  std::vector<std::uint32_t> leaving_;  // by node
  std::vector<std::uint8_t> walked_;    // by node
  std::vector<Known> known_;
  std::int32_t least_winding_ = 0;
};

}  // namespace core
