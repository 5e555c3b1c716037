// The winding number beside a point, by a ray.
//
//     ────────────────────────•     The ray runs west from the point, a hair north of it, so that
//                                    it passes no corner. Every edge that it meets adds its weight
//                                    or takes it away.
//
// Where there are many rings, only those count whose boxes hold the point: the others go around it
// not at all. The ray ends where the last of these boxes does.
//
// The edges are those that snap rounding leaves: bent edges count as they are bent. Edges through
// the point itself don't count.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/booleans/contour_edges.h"  // ContourEdges
#include "core/booleans/edge_tree.h"      // EdgeTree
#include "core/booleans/snap_rounding.h"  // SnapRounding
#include "core/regions/box_tree.h"        // BoxTree, RingOrder

namespace core {

// How the operands' windings add up.
struct OperandWeights {
  // Of rings of any kind: one. Of two operands: theirs, and that of the rings that stand alike in
  // both.
  std::vector<std::int32_t> by_operand;
  // Two operands, and each is clean: a ring has its own inside on its left and its own outside on
  // its right.
  bool clean = true;
};

inline constexpr std::uint32_t kOperandInCommon = 2;

class WindingRay {
 public:
  // Keeps references to its arguments until the next reset. Memory is kept, too.
  void reset(const ContourEdges& edges, const EdgeTree& tree, const SnapRounding& snapped,
             const OperandWeights& weights);

  // Of the sector at the point that holds the direction a hair north of west.
  // COSTS: O(edges at this height west of the point, as far as rings may go around it).
  [[nodiscard]] std::int32_t winding_at(Point p);

  // On the right of a ring at one of its corners.
  // REQUIRES: operands are clean; the ring is of this operand, and no edge of another lies there.
  // COSTS: as winding_at(), but it ends at the nearest edge of the other operand.
  [[nodiscard]] std::int32_t winding_right_of(std::uint32_t operand, Point corner);

 private:
  [[nodiscard]] std::int32_t sum_west_of(Point p, std::span<const std::int32_t> weights);
  [[nodiscard]] std::optional<bool> covered_by_other(std::uint32_t operand, Point p);
  [[nodiscard]] bool find_rings_around(Point p, std::uint32_t but);
  void plant_ring_tree();
  [[nodiscard]] bool may_go_around(EdgeIndex edge) const {
    return few_rings_ || around_[edges_->ring_index(edge)] == ray_;
  }
  template <typename Visit>
  void for_pieces(EdgeIndex edge, Visit visit) const;
  [[nodiscard]] int turns(EdgeIndex edge, Point p) const;
  [[nodiscard]] int crossings(EdgeIndex edge, Point p, Segment& piece) const;

  const ContourEdges* edges_ = nullptr;
  const EdgeTree* tree_ = nullptr;
  const SnapRounding* snapped_ = nullptr;
  const OperandWeights* weights_ = nullptr;
  std::vector<std::int32_t> others_;  // the weights without one operand's share
  std::vector<std::uint32_t> seen_;   // by edge: the last ray that met it
  std::uint32_t ray_ = 0;
  bool few_rings_ = true;  // all count
  bool ring_tree_planted_ = false;
  BoxTree ring_tree_;
  RingOrder order_;
  std::vector<Box> ring_boxes_;
  std::vector<std::uint32_t> around_;  // by ring: the last ray for which it counted
  std::int32_t west_ = INT32_MIN;      // where the ray ends
};

}  // namespace core
