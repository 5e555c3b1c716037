#include "core/booleans/edge_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/limits.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"

using core::Point;
using test::Random;

namespace {

core::ContourEdges edges_in_square(Random& random, int rings, int size) {
  core::ContourEdges edges;
  for (int i = 0; i < rings; ++i) {
    core::Ring ring;
    for (int corner = random.integer(3, 9); corner > 0; --corner) {
      ring.push_back({random.integer(-size, size), random.integer(-size, size)});
    }
    edges.add_mended(ring, 1, 0);
  }
  return edges;
}

// Every edge nearer than a unit to a random point beside an edge is in the point's cell.
void check_cells(Random& random, const core::ContourEdges& edges) {
  if (edges.rings().empty()) return;
  core::EdgeGrid grid;
  grid.build(edges);
  for (std::uint32_t cell = 0; cell < grid.cell_count(); ++cell) {
    const auto found = grid.edges_in(cell);
    REQUIRE(std::is_sorted(found.begin(), found.end()));
  }
  for (const core::ContourRing& ring : edges.rings()) {
    for (core::EdgeIndex edge = ring.first; edge < ring.end; ++edge) {
      const Point a = edges.from(edge), b = edges.to(edge);
      const double t = random.unit();
      const Point p{
          static_cast<std::int32_t>(std::lround(a.x + t * (static_cast<double>(b.x) - a.x))),
          static_cast<std::int32_t>(std::lround(a.y + t * (static_cast<double>(b.y) - a.y)))};
      const core::Box& box = edges.box();
      REQUIRE((box.min.x <= p.x && p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y));
      const auto found = grid.edges_in(grid.cell_of(p));
      CHECK(std::binary_search(found.begin(), found.end(), edge));
      for (const core::ContourRing& other_ring : edges.rings()) {
        for (core::EdgeIndex other = other_ring.first; other < other_ring.end; ++other) {
          if (test::distance_to_segment(p, {edges.from(other), edges.to(other)}) >= 1) continue;
          CHECK(std::binary_search(found.begin(), found.end(), other));
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("an edge is found from every point nearer than a unit to it") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const int sizes[] = {6, 300, 1'000'000, core::kCoordinateMax};
    check_cells(random, edges_in_square(random, random.integer(1, 12), sizes[seed % 4]));
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
  check_cells(random, edges);
}

TEST_CASE("columns start where the cells of a row do") {
  Random random(3);
  core::EdgeGrid grid;
  grid.build(edges_in_square(random, 20, 10'000));
  for (std::uint32_t column = 0; column < grid.columns(); ++column) {
    const std::int32_t west = grid.column_west(column);
    CHECK_EQ(grid.cell_of({west, 0}) % grid.columns(), column);
    if (column > 0) CHECK_EQ(grid.cell_of({west - 1, 0}) % grid.columns(), column - 1);
  }
}
