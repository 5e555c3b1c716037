#include "core/booleans/chain_graph.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "tests/support/arrangement.h"
#include "tests/support/random_regions.h"

using core::EdgeChain;
using core::Point;
using core::Spoke;
using test::Arrangement;
using test::Random;

namespace {

// Counter-clockwise from due west, 0 … 2π.
double angle_from_west(Point node, Point toward) {
  const double x = static_cast<double>(toward.x) - node.x,
               y = static_cast<double>(toward.y) - node.y;
  const double angle = std::atan2(-y, -x);
  return angle < 0 ? angle + 2 * std::acos(-1.0) : angle;
}

// A chain's points from node to node.
std::vector<Point> points_of(const Arrangement& drawn, const EdgeChain& chain) {
  std::vector<Point> points{drawn.snapped.nodes()[chain.start]};
  core::for_corners(chain, drawn.edges, [&](Point corner) { points.push_back(corner); });
  points.push_back(drawn.snapped.nodes()[chain.end]);
  return points;
}

}  // namespace

TEST_CASE("chains, one behind the other, are the rings' bent pieces") {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Arrangement drawn(test::small_rings(random, random.integer(3, 14)));
    if (drawn.edges.rings().empty()) continue;
    std::size_t pieces = 0;
    for (const EdgeChain& chain : drawn.graph.chains()) {
      const std::vector<Point> points = points_of(drawn, chain);
      pieces += points.size() - 1;
      CHECK(drawn.graph.has_chains(chain.ring));
      for (std::uint32_t i = 0; i < chain.corner_count; ++i) {
        CHECK_EQ(core::corner(chain, drawn.edges, i), points[i + 1]);
      }
    }
    std::size_t wanted = 0;
    for (const core::Segment& piece : drawn.pieces()) wanted += piece.from != piece.to ? 1 : 0;
    CHECK_EQ(pieces, wanted);
  }
}

TEST_CASE("both ends of every chain are spokes, counter-clockwise from due west") {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Arrangement drawn(test::small_rings(random, random.integer(3, 14)));
    if (drawn.edges.rings().empty()) continue;
    std::vector<int> seen(2 * drawn.graph.chains().size(), 0);
    for (core::NodeIndex node = 0; node < drawn.graph.node_count(); ++node) {
      const Point at = drawn.snapped.nodes()[node];
      double last = -1;
      for (const Spoke& spoke : drawn.graph.spokes(node)) {
        ++seen[spoke.end];
        CHECK_EQ(drawn.graph.node_at(spoke.end), node);
        const std::vector<Point> points = points_of(drawn, drawn.graph.chains()[spoke.end / 2]);
        CHECK_EQ(spoke.toward, spoke.end % 2 == 0 ? points[1] : points[points.size() - 2]);
        const double angle = angle_from_west(at, spoke.toward);
        CHECK_GE(angle, last - 1e-12);
        last = angle;
      }
    }
    for (const int count : seen) CHECK_EQ(count, 1);
  }
}
