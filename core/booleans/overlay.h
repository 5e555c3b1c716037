// One boolean operation: all rings laid over one another, and the region where their winding
// numbers say "inside".
//
//     rings ──> edges ──> tree ──> nodes ──> chains ──> boundary ──> rings
//     contour_edges  edge_tree  snap_rounding  chain_graph  boundary_walk  ring_tracer
//
// Points are rounded once, at the crossings, by at most half a unit in x and in y. Everything that
// decides topology is exact integer arithmetic. Corners that nothing comes near stay as they are,
// and rings that meet nothing are copied whole.
//
// An Overlay keeps its memory from one operation to the next, so that in the steady state only the
// result is allocated.
#pragma once

#include <cstdint>
#include <vector>

#include "core/booleans/boundary_walk.h"
#include "core/booleans/chain_graph.h"
#include "core/booleans/contour_edges.h"
#include "core/booleans/edge_tree.h"
#include "core/booleans/ring_tracer.h"
#include "core/booleans/snap_rounding.h"
#include "core/booleans/winding_ray.h"
#include "core/booleans/winding_rule.h"
#include "core/regions/region.h"

namespace core {

class Overlay {
 public:
  // Rings that are in both operands are found and taken as one.
  // REQUIRES: every operand is clean. One that crosses itself is noticed as a rule, and costs a
  // second run in which every edge may cross every other. The result is always clean.
  // COSTS: near-linear in edges + crossings (snap_rounding.h).
  [[nodiscard]] Region combine(const Region& a, std::int32_t weight_a, const Region& b,
                               std::int32_t weight_b, const WindingRule& rule);

  // Rings of any kind, weighted 1.
  [[nodiscard]] Region combine(const std::vector<Ring>& rings, const WindingRule& rule);

  // The lowest winding number in the last operation, or 0. REQUIRES: that was on rings of any kind.
  [[nodiscard]] std::int32_t least_winding() const { return walk_.least_winding(); }

  // Second runs so far.
  [[nodiscard]] std::int64_t retries() const { return retries_; }

 private:
  void add_in_common(const Region& a, const Region& b);
  [[nodiscard]] Region run(const WindingRule& rule);
  [[nodiscard]] bool find_boundary(const WindingRule& rule);
  void copy_free_rings(const WindingRule& rule, std::vector<Ring>& rings);

  ContourEdges edges_;
  EdgeTree tree_;
  SnapRounding snapped_;
  ChainGraph graph_;
  WindingRay ray_;
  BoundaryWalk walk_;
  RingTracer tracer_;
  OperandWeights weights_;
  std::vector<Ring> found_;  // the result, until its size is known
  std::int64_t retries_ = 0;
  std::vector<std::uint8_t> common_a_;  // by ring of a: it is in b, too
  std::vector<std::uint8_t> common_b_;
};

}  // namespace core
