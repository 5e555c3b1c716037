#include "core/booleans/ring_tracer.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "core/booleans/boundary_walk.h"
#include "core/regions/region.h"
#include "tests/support/arrangement.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"

using core::Point;
using core::Region;
using core::Ring;
using core::WindingRule;
using test::Arrangement;
using test::Random;

namespace {

std::vector<Ring> traced(const Arrangement& drawn, const WindingRule& rule) {
  const core::OperandWeights weights{{1}, false};
  core::WindingRay ray;
  ray.reset(drawn.edges, drawn.tree, drawn.snapped, weights);
  core::BoundaryWalk walk;
  REQUIRE(walk.run(drawn.edges, drawn.snapped, drawn.graph, ray, rule, false));
  core::RingTracer tracer;
  std::vector<Ring> rings;
  tracer.trace(drawn.edges, drawn.snapped, drawn.graph, walk, rings);
  return rings;
}

}  // namespace

TEST_CASE("rings enclose what the rule says, are clean, and pass no point twice") {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const int size = random.integer(3, 14);
    const Arrangement drawn(test::small_rings(random, size));
    if (drawn.edges.rings().empty()) continue;
    const WindingRule rule{WindingRule::Kind::kNonZero, 0};
    const std::vector<Ring> rings = traced(drawn, rule);
    CHECK(test::is_clean(Region::from_clean_rings(rings)));
    std::map<Point, int> passed;
    for (const Ring& ring : rings) {
      for (const Point p : ring) ++passed[p];
    }
    for (const Ring& ring : rings) {
      CHECK((std::min_element(ring.begin(), ring.end()) == ring.begin()));
      CHECK_EQ(std::set<Point>(ring.begin(), ring.end()).size(), ring.size());
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point before = ring[i > 0 ? i - 1 : ring.size() - 1];
        const Point after = ring[i + 1 < ring.size() ? i + 1 : 0];
        const bool is_node = std::find(drawn.snapped.nodes().begin(), drawn.snapped.nodes().end(),
                                       ring[i]) != drawn.snapped.nodes().end();
        if (is_node && passed[ring[i]] == 1) CHECK_NE(core::cross(before, ring[i], after), 0);
      }
    }
    for (int i = 0; i < 40; ++i) {
      const double x = random.between(-1, size), y = random.between(-1, size);
      CHECK_EQ(test::winding_number(rings, x, y), rule.inside(drawn.winding(x, y)) ? 1 : 0);
    }
  }
}

TEST_CASE("a ring is written from its least point on, in either direction") {
  const Ring ring{{5, 1}, {7, 7}, {2, 9}, {2, 3}};
  CHECK_EQ(core::canonical_ring(ring.data(), ring.data() + ring.size(), core::Turned::kNo),
           Ring{{2, 3}, {5, 1}, {7, 7}, {2, 9}});
  CHECK_EQ(core::canonical_ring(ring.data(), ring.data() + ring.size(), core::Turned::kYes),
           Ring{{2, 3}, {2, 9}, {7, 7}, {5, 1}});
}

TEST_CASE("rings are sorted by their first points, then by their second ones") {
  const Ring a{{0, 0}, {5, 0}, {0, 5}}, b{{0, 0}, {6, 0}, {0, 5}}, c{{0, 1}, {1, 1}, {0, 2}};
  std::vector<Ring> rings{c, b, a};
  core::sort_rings(rings);
  CHECK_EQ(rings, std::vector<Ring>{a, b, c});
  CHECK(core::ring_before(a, b));
  CHECK_FALSE(core::ring_before(b, a));
}
