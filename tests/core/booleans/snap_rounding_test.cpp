#include "core/booleans/snap_rounding.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "core/booleans/hot_pixel.h"
#include "tests/support/arrangement.h"
#include "tests/support/random_regions.h"

using core::EdgeIndex;
using core::Point;
using core::Segment;
using test::Arrangement;
using test::Random;

namespace {

int side(const Segment& line, Point p) {
  const std::int64_t turn = core::cross(line.from, line.to, p);
  return (turn > 0) - (turn < 0);
}

bool within(const Segment& s, Point p) {
  return p != s.from && p != s.to && side(s, p) == 0 && core::box_of(s).overlaps(core::Box{p, p});
}

bool cross_inside(const Segment& a, const Segment& b) {
  return side(a, b.from) * side(a, b.to) < 0 && side(b, a.from) * side(b, a.to) < 0;
}

}  // namespace

TEST_CASE("pieces meet in nothing but their ends, or lie on one another from end to end") {
  for (std::uint64_t seed = 1; seed <= 1'500; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Arrangement drawn(test::small_rings(random, random.integer(3, 14)));
    if (drawn.edges.rings().empty()) continue;
    const std::vector<Segment> pieces = drawn.pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t k = i + 1; k < pieces.size(); ++k) {
        REQUIRE_FALSE(cross_inside(pieces[i], pieces[k]));
        for (const auto& [s, other] : {std::pair{pieces[i], pieces[k]}, {pieces[k], pieces[i]}}) {
          REQUIRE_FALSE(within(s, other.from));
          REQUIRE_FALSE(within(s, other.to));
        }
      }
    }
  }
}

TEST_CASE(
    "every crossing's pixel is a node, and edges run through the nodes whose pixel they pass") {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Arrangement drawn(test::small_rings(random, random.integer(3, 20)));
    if (drawn.edges.rings().empty()) continue;
    const auto nodes = drawn.snapped.nodes();
    const auto meeting = nodes.first(drawn.meeting_nodes);
    std::vector<EdgeIndex> all;
    for (const core::ContourRing& ring : drawn.edges.rings()) {
      for (EdgeIndex edge = ring.first; edge < ring.end; ++edge) all.push_back(edge);
    }
    for (const EdgeIndex e : all) {
      const Segment one{drawn.edges.from(e), drawn.edges.to(e)};
      for (const EdgeIndex f : all) {
        const Segment other{drawn.edges.from(f), drawn.edges.to(f)};
        if (!cross_inside(one, other)) continue;
        const Point pixel = core::crossing_pixel(one.from, one.to, other.from, other.to);
        CHECK(std::find(meeting.begin(), meeting.end(), pixel) != meeting.end());
      }
      std::vector<Point> passed;
      for (const core::Passage& passage : drawn.snapped.passages_of(e)) {
        passed.push_back(nodes[passage.node]);
        CHECK(core::passes_pixel(one.from, one.to, passed.back()));
      }
      for (const Point node : meeting) {
        // An edge's last point is the next edge's first.
        if (node == one.to || !core::passes_pixel(one.from, one.to, node)) continue;
        CHECK(std::find(passed.begin(), passed.end(), node) != passed.end());
      }
    }
  }
}

TEST_CASE("passages ascend along each edge, and a bent edge is one that leaves its straight line") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Arrangement drawn(test::small_rings(random, 12));
    if (drawn.edges.rings().empty()) continue;
    const auto passages = drawn.snapped.passages();
    for (std::size_t i = 1; i < passages.size(); ++i) {
      const auto key = [](const core::Passage& p) { return std::pair(p.edge, p.along); };
      CHECK(key(passages[i - 1]) < key(passages[i]));
    }
    for (const core::ContourRing& ring : drawn.edges.rings()) {
      for (EdgeIndex edge = ring.first; edge < ring.end; ++edge) {
        const Segment line{drawn.edges.from(edge), drawn.edges.to(edge)};
        const std::vector<Point> course = drawn.course(edge);
        const bool leaves =
            std::any_of(course.begin(), course.end(), [&](Point p) { return side(line, p) != 0; });
        CHECK_EQ(drawn.snapped.bent(edge), leaves);
      }
    }
  }
}

TEST_CASE("rings that meet nothing stay as they are") {
  const Arrangement drawn({{{0, 0}, {9, 1}, {4, 8}}, {{20, 20}, {29, 20}, {25, 27}}});
  CHECK_EQ(drawn.pieces().size(), 6);
  // One node for each, so that there is a chain to start from.
  CHECK_EQ(drawn.snapped.nodes().size(), 2);
}
