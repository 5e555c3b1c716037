// All rings of one operation on one sheet, and the region where their winding numbers say "inside".
//
//     rings ──> edges ──> grid ──> nodes ──> chains ──> boundary ──> rings
//     contour_edges  edge_grid  snap_rounding  chain_graph  boundary_walk  ring_tracer
//
// Everything is rounded once, at the crossings, by at most half a unit in x and in y; everything
// that decides topology is exact integer arithmetic. Corners that nothing comes near stay as they
// are, and rings that meet nothing are copied whole.
//
// One Overlay does one operation after another and keeps its memory in between, so that in the
// steady state only the result is allocated.
#pragma once

#include <cstdint>
#include <vector>

#include "core/booleans/boundary_walk.h"
#include "core/booleans/chain_graph.h"
#include "core/booleans/contour_edges.h"
#include "core/booleans/edge_grid.h"
#include "core/booleans/ring_tracer.h"
#include "core/booleans/snap_rounding.h"
#include "core/booleans/winding_ray.h"
#include "core/booleans/winding_rule.h"
#include "core/regions/region.h"

namespace core {

class Overlay {
 public:
  // Rings that stand alike in both are found and taken as one.
  // REQUIRES: every operand is clean. One that crosses itself after all is noticed, as a rule, and
  // costs a second run in which everything may cross everything: the result is clean always.
  // COSTS: near-linear in edges + crossings (snap_rounding.h).
  [[nodiscard]] Region combine(const Region& a, std::int32_t weight_a, const Region& b,
                               std::int32_t weight_b, const WindingRule& rule);

  // Rings of any kind, weighted 1.
  [[nodiscard]] Region combine(const std::vector<Ring>& rings, const WindingRule& rule);

  // The lowest winding number in the last operation, or 0. REQUIRES: it was on rings of any kind
  [[nodiscard]] std::int32_t least_winding() const { return walk_.least_winding(); }

  // Second runs since birth.
  [[nodiscard]] std::int64_t retries() const { return retries_; }

 private:
  void add_in_common(const Region& a, const Region& b);
  [[nodiscard]] Region run(const WindingRule& rule);
  [[nodiscard]] bool find_boundary(const WindingRule& rule);
  void copy_free_rings(const WindingRule& rule, std::vector<Ring>& rings);

  ContourEdges edges_;
  EdgeGrid grid_;
  SnapRounding snapped_;
  ChainGraph graph_;
  WindingRay ray_;
  BoundaryWalk walk_;
  RingTracer tracer_;
  OperandWeights weights_;
  std::vector<Ring> found_;  // the result, until its size is known
  std::int64_t retries_ = 0;
  std::vector<std::uint8_t> common_a_;  // by ring of a: stands alike in b
  std::vector<std::uint8_t> common_b_;
};

}  // namespace core
