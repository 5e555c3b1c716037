// Rings taken through the first steps of a boolean operation, for tests of each step: edges, tree,
// nodes, chains, and the edges as snap rounding has bent them.
#pragma once

#include <algorithm>
#include <vector>

#include "core/booleans/chain_graph.h"
#include "core/booleans/contour_edges.h"
#include "core/booleans/edge_tree.h"
#include "core/booleans/snap_rounding.h"
#include "core/geometry.h"
#include "tests/support/random_regions.h"

namespace test {

struct Arrangement {
  core::ContourEdges edges;
  core::EdgeTree tree;
  core::SnapRounding snapped;
  core::ChainGraph graph;
  // Nodes where edges meet come first; the others only give a ring without any a point to start at.
  std::size_t meeting_nodes = 0;

  // Rings of any kind, each of weight 1. If they vanish when they are mended, nothing is made.
  explicit Arrangement(const std::vector<core::Ring>& rings) {
    for (const core::Ring& ring : rings) edges.add_mended(ring, 1, 0);
    if (edges.rings().empty()) return;
    tree.build(edges);
    snapped.run(edges, tree, core::Meetings::kAll);
    meeting_nodes = snapped.nodes().size();
    snapped.add_node_to_rings_without(edges);
    graph.build(edges, snapped);
  }

  // The course of an edge: its first point, the nodes that it runs through, its last point.
  [[nodiscard]] std::vector<core::Point> course(core::EdgeIndex edge) const {
    std::vector<core::Point> points{edges.from(edge)};
    const auto add = [&points](core::Point p) {
      if (points.back() != p) points.push_back(p);
    };
    for (const core::Passage& passage : snapped.passages_of(edge)) {
      add(snapped.nodes()[passage.node]);
    }
    add(edges.to(edge));
    return points;
  }

  // The straight pieces of all edges, as they are bent.
  [[nodiscard]] std::vector<core::Segment> pieces() const {
    std::vector<core::Segment> all;
    for (const core::ContourRing& ring : edges.rings()) {
      for (core::EdgeIndex edge = ring.first; edge < ring.end; ++edge) {
        const std::vector<core::Point> points = course(edge);
        for (std::size_t i = 1; i < points.size(); ++i) all.push_back({points[i - 1], points[i]});
      }
    }
    return all;
  }

  // The winding number at a point that lies on no piece.
  [[nodiscard]] int winding(double x, double y) const {
    int sum = 0;
    for (const core::Segment& piece : pieces()) {
      const double turn = (static_cast<double>(piece.to.x) - piece.from.x) * (y - piece.from.y) -
                          (static_cast<double>(piece.to.y) - piece.from.y) * (x - piece.from.x);
      if (piece.from.y <= y && piece.to.y > y && turn > 0) ++sum;
      if (piece.to.y <= y && piece.from.y > y && turn < 0) --sum;
    }
    return sum;
  }
};

// One to three rings of three to seven corners on a grid of `size` × `size` points: crossings,
// corners on edges and edges in common are frequent.
inline std::vector<core::Ring> small_rings(Random& random, int size) {
  std::vector<core::Ring> rings(static_cast<std::size_t>(random.integer(1, 3)));
  for (core::Ring& ring : rings) {
    const int corners = random.integer(3, 7);
    for (int i = 0; i < corners; ++i) {
      ring.push_back({random.integer(0, size - 1), random.integer(0, size - 1)});
    }
  }
  return rings;
}

}  // namespace test
