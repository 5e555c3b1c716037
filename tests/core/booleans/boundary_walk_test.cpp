#include "core/booleans/boundary_walk.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tests/support/arrangement.h"
#include "tests/support/random_regions.h"

using core::BoundaryPiece;
using core::Point;
using core::Segment;
using core::WindingRule;
using test::Arrangement;
using test::Random;

namespace {

// The first straight stretch of a piece, in its own direction.
Segment first_stretch(const Arrangement& drawn, BoundaryPiece piece) {
  const core::EdgeChain& chain = drawn.graph.chains()[piece / 2];
  std::vector<Point> points{drawn.snapped.nodes()[chain.start]};
  core::for_corners(chain, drawn.edges, [&](Point corner) { points.push_back(corner); });
  points.push_back(drawn.snapped.nodes()[chain.end]);
  if (piece % 2 != 0) std::reverse(points.begin(), points.end());
  return {points[0], points[1]};
}

// The winding number just beside the middle of a stretch; left: 1, right: -1.
int winding_beside(const Arrangement& drawn, const Segment& s, int side) {
  const double dx = static_cast<double>(s.to.x) - s.from.x;
  const double dy = static_cast<double>(s.to.y) - s.from.y;
  const double x = (static_cast<double>(s.from.x) + s.to.x) / 2 - side * dy * 1e-5;
  const double y = (static_cast<double>(s.from.y) + s.to.y) / 2 + side * dx * 1e-5;
  // Off the lines of the grid, on which corners lie.
  return drawn.winding(x + 1.3e-9, y + 1.7e-9);
}

void check(const Arrangement& drawn, const WindingRule& rule) {
  const core::OperandWeights weights{{1}, false};
  core::WindingRay ray;
  ray.reset(drawn.edges, drawn.tree, drawn.snapped, weights);
  core::BoundaryWalk walk;
  REQUIRE(walk.run(drawn.edges, drawn.snapped, drawn.graph, ray, rule, false));

  std::set<Segment> listed, wanted;
  int least = 0;
  for (const BoundaryPiece piece : walk.pieces()) {
    CHECK(listed.insert(first_stretch(drawn, piece)).second);
  }
  for (BoundaryPiece piece = 0; piece < 2 * drawn.graph.chains().size(); ++piece) {
    const Segment stretch = first_stretch(drawn, piece);
    const int left = winding_beside(drawn, stretch, 1), right = winding_beside(drawn, stretch, -1);
    least = std::min({least, left, right});
    if (rule.inside(left) && !rule.inside(right)) wanted.insert(stretch);
  }
  CHECK(listed == wanted);
  CHECK_EQ(walk.least_winding(), least);

  // Pieces follow one another at nodes, each has one before it.
  std::set<BoundaryPiece> followed;
  for (const BoundaryPiece piece : walk.pieces()) {
    const BoundaryPiece next = walk.next(piece);
    CHECK(followed.insert(next).second);
    CHECK_EQ(drawn.graph.node_at(piece ^ 1), drawn.graph.node_at(next));
  }
  CHECK_EQ(followed.size(), walk.pieces().size());
}

}  // namespace

TEST_CASE("the boundary is what has the inside on its left and the outside on its right") {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Arrangement drawn(test::small_rings(random, random.integer(3, 14)));
    if (drawn.edges.rings().empty()) continue;
    check(drawn, {WindingRule::Kind::kAtLeast, 1});
    check(drawn, {WindingRule::Kind::kNonZero, 0});
    check(drawn, {WindingRule::Kind::kOdd, 0});
    check(drawn, {WindingRule::Kind::kAtLeast, 2});
  }
}
