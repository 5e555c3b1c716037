#include "core/booleans/edge_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "core/booleans/hot_pixel.h"
#include "core/limits.h"
#include "tests/support/random_regions.h"

using core::Box;
using core::EdgeIndex;
using core::Point;
using core::Segment;
using test::Random;

namespace {

// Few long edges among short ones, so that long ones have several parts.
core::ContourEdges random_edges(Random& random, int rings, int size) {
  core::ContourEdges edges;
  const int operands = random.integer(1, 3);
  for (int i = 0; i < rings; ++i) {
    core::Ring ring;
    const int reach = random.integer(0, 3) == 0 ? size : std::max(3, size / 40);
    const Point at{random.integer(-size, size) / 2, random.integer(-size, size) / 2};
    for (int corner = random.integer(3, 30); corner > 0; --corner) {
      ring.push_back(
          {at.x + random.integer(-reach, reach) / 2, at.y + random.integer(-reach, reach) / 2});
    }
    edges.add_mended(ring, 1, static_cast<std::uint32_t>(operands * i / rings));
  }
  return edges;
}

std::vector<EdgeIndex> all_edges(const core::ContourEdges& edges) {
  std::vector<EdgeIndex> all;
  for (const core::ContourRing& ring : edges.rings()) {
    for (EdgeIndex edge = ring.first; edge < ring.end; ++edge) all.push_back(edge);
  }
  return all;
}

Segment line(const core::ContourEdges& edges, EdgeIndex edge) {
  return {edges.from(edge), edges.to(edge)};
}

std::set<EdgeIndex> found_in(const core::EdgeTree& tree, const Box& box,
                             std::uint32_t but = core::kNoOperand) {
  std::set<EdgeIndex> found;
  tree.for_edges_in(box, but, [&found](EdgeIndex edge) { found.insert(edge); });
  return found;
}

bool touch(const Segment& a, const Segment& b) {
  const auto side = [](const Segment& s, Point p) {
    const std::int64_t turn = core::cross(s.from, s.to, p);
    return (turn > 0) - (turn < 0);
  };
  return core::box_of(a).overlaps(core::box_of(b)) && side(a, b.from) * side(a, b.to) <= 0 &&
         side(b, a.from) * side(b, a.to) <= 0;
}

Point place_on(const Segment& edge, double t) {
  return {static_cast<std::int32_t>(
              std::lround(edge.from.x + t * (static_cast<double>(edge.to.x) - edge.from.x))),
          static_cast<std::int32_t>(
              std::lround(edge.from.y + t * (static_cast<double>(edge.to.y) - edge.from.y)))};
}

using Pair = std::pair<EdgeIndex, EdgeIndex>;

void check_tree(Random& random, const core::ContourEdges& edges) {
  if (edges.rings().empty()) return;
  core::EdgeTree tree;
  tree.build(edges);
  std::set<Pair> pairs, across;
  tree.for_all_pairs([&](EdgeIndex e, EdgeIndex f) { pairs.insert(std::minmax(e, f)); });
  tree.for_pairs_across([&](EdgeIndex e, EdgeIndex f) {
    CHECK_NE(edges.ring(e).operand, edges.ring(f).operand);
    across.insert(std::minmax(e, f));
  });
  const std::vector<EdgeIndex> all = all_edges(edges);
  for (const EdgeIndex e : all) {
    const Segment one = line(edges, e);
    const Point p = place_on(one, random.unit());
    const std::set<EdgeIndex> here = found_in(tree, {p, p});
    const std::uint32_t operand = edges.ring(e).operand;
    const std::set<EdgeIndex> others = found_in(tree, {p, p}, operand);
    std::set<EdgeIndex> along;
    tree.for_boxes(one.from, one.to, [&](const Box& box) { along.merge(found_in(tree, box)); });
    CHECK(here.contains(e));
    for (const EdgeIndex f : all) {
      const Segment other = line(edges, f);
      if (core::passes_pixel(other.from, other.to, p)) CHECK(here.contains(f));
      CHECK_EQ(others.contains(f), here.contains(f) && edges.ring(f).operand != operand);
      const bool passed = core::passes_pixel(one.from, one.to, other.from) ||
                          core::passes_pixel(other.from, other.to, one.from);
      if (passed) CHECK(along.contains(f));
      if (f <= e || !touch(one, other)) continue;
      CHECK(pairs.contains({e, f}));
      if (edges.ring(f).operand != operand) CHECK(across.contains({e, f}));
    }
  }
}

}  // namespace

TEST_CASE("an edge is found from every point whose pixel it passes, and with all that it meets") {
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const int sizes[] = {6, 300, 1'000'000, core::kCoordinateMax};
    check_tree(random, random_edges(random, random.integer(1, 24), sizes[seed % 4]));
  }
}

TEST_CASE("it is found where most edges crowd in one spot of a large plate, too") {
  Random random(7);
  core::ContourEdges edges;
  edges.add({{-5'000'000, -5'000'000}, {5'000'000, -5'000'000}, {0, 5'000'000}}, 1, 0);
  for (int i = 0; i < 200; ++i) {
    const Point at{random.integer(0, 2'000), random.integer(0, 2'000)};
    edges.add({at, {at.x + 40, at.y + random.integer(1, 9)}, {at.x + 3, at.y + 50}}, 1, 0);
  }
  check_tree(random, edges);
}

TEST_CASE("a long slanting edge is not found all over the box around it") {
  core::ContourEdges edges;
  edges.add({{0, 0}, {1'000'000, 1'000'000}, {999'000, 1'000'000}}, 1, 0);
  for (int i = 0; i < 300; ++i) {
    const Point at{900'000 + 100 * i, 100 * i};
    edges.add({at, {at.x + 90, at.y}, {at.x, at.y + 90}}, 1, 1);
  }
  core::EdgeTree tree;
  tree.build(edges);
  int pairs = 0;
  tree.for_pairs_across([&pairs](EdgeIndex, EdgeIndex) { ++pairs; });
  CHECK_EQ(pairs, 0);
}
