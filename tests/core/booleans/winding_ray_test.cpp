#include "core/booleans/winding_ray.h"

#include <doctest/doctest.h>

#include <vector>

#include "core/booleans/boolean.h"
#include "tests/support/arrangement.h"
#include "tests/support/grid_regions.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"

using core::Point;
using core::Region;
using test::Arrangement;
using test::Random;

TEST_CASE("the winding number a hair north of west of a node is that of all pieces") {
  for (std::uint64_t seed = 1; seed <= 800; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Arrangement drawn(test::small_rings(random, random.integer(3, 14)));
    if (drawn.edges.rings().empty()) continue;
    const core::OperandWeights weights{{1}, false};
    core::WindingRay ray;
    ray.reset(drawn.edges, drawn.tree, drawn.snapped, weights);
    for (const Point node : drawn.snapped.nodes()) {
      // No piece that ends at the node lies between: slopes on this grid are 1/14 at least.
      CHECK_EQ(ray.winding_at(node), drawn.winding(node.x - 1e-3, node.y + 1e-6));
    }
  }
}

TEST_CASE("what lies on the right of a clean ring is told by the other operand") {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region a = test::random_grid_region(random, 1'000);
    const Region b = test::random_grid_region(random, 997);
    core::ContourEdges edges;
    for (const core::Ring& ring : a.rings()) edges.add(ring, 3, 0);
    for (const core::Ring& ring : b.rings()) edges.add(ring, 5, 1);
    if (edges.rings().empty()) continue;
    core::EdgeTree tree;
    tree.build(edges);
    core::SnapRounding snapped;
    snapped.run(edges, tree, core::Meetings::kAcrossOperands);
    const core::OperandWeights weights{{3, 5, 8}, true};
    core::WindingRay ray;
    ray.reset(edges, tree, snapped, weights);
    for (const core::ContourRing& ring : edges.rings()) {
      for (core::EdgeIndex edge = ring.first; edge < ring.end; ++edge) {
        const Point corner = edges.from(edge);
        const Region& other = ring.operand == 0 ? b : a;
        if (test::distance_to_boundary(other.rings(), corner.x, corner.y) < 3) continue;
        const bool covered = test::winding_number(other.rings(), corner.x, corner.y) > 0;
        CHECK_EQ(ray.winding_right_of(ring.operand, corner),
                 covered ? (ring.operand == 0 ? 5 : 3) : 0);
        ++compared;
      }
    }
  }
  CHECK_GT(compared, 500);
}
