#include "core/offsets/offset_search.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "core/offsets/offset_runs.h"
#include "tests/support/grid_regions.h"
#include "tests/support/offset_elements.h"
#include "tests/support/random_regions.h"

using core::OffsetInput;
using core::OffsetSearch;
using core::Region;
using test::Random;

namespace {

// Every chunk with an edge of another run within reach of an element's points is found.
void check_search(const Region& region, bool mirrored, double deepest, int& found) {
  OffsetInput contours;
  contours.load(region, mirrored);
  core::find_runs(contours, deepest);
  OffsetSearch search;
  search.prepare(contours, deepest);
  CHECK_EQ(search.deepest(), deepest);
  std::vector<std::size_t> chunk_of(contours.edges().size());
  for (std::size_t i = 0; i < search.chunks().size(); ++i) {
    for (auto e = search.chunks()[i].first; e < search.chunks()[i].last; ++e) {
      chunk_of[static_cast<std::size_t>(e)] = i;
    }
  }
  for (std::size_t i = 0; i < contours.edges().size(); ++i) {
    const auto neighbours = search.neighbours(chunk_of[i]);
    for (int k = 0; k <= 4; ++k) {
      const test::ElementPoint p =
          test::on_line(contours, i, contours.edges()[i].length * k / 4, deepest);
      for (std::size_t other = 0; other < contours.edges().size(); ++other) {
        if (contours.edges()[other].run == contours.edges()[i].run) continue;
        if (test::distance_to_edge(contours.edges()[other], p) > deepest) continue;
        ++found;
        CHECK(std::find(neighbours.begin(), neighbours.end(),
                        static_cast<std::int32_t>(chunk_of[other])) != neighbours.end());
      }
    }
  }
}

}  // namespace

TEST_CASE("whatever is within the depth of an element is among its chunk's neighbours") {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = seed % 3 == 0 ? test::random_grid_region(random, 1'000)
                                        : test::random_region(random, 120, 20);
    for (const double deepest : {100.0, 3'000.0, 40'000.0}) {
      check_search(region, false, deepest, found);
      check_search(region, true, deepest, found);
    }
  }
  CHECK_GT(found, 10'000);
}

TEST_CASE("chunks hold every edge once, in order, and their boxes hold their edges") {
  Random random(5);
  OffsetInput contours;
  contours.load(test::random_region(random, 300, 30), false);
  core::find_runs(contours, 5'000);
  OffsetSearch search;
  search.prepare(contours, 5'000);
  std::int32_t next = 0;
  for (const core::OffsetChunk& chunk : search.chunks()) {
    CHECK_EQ(chunk.first, next);
    CHECK_GT(chunk.last, chunk.first);
    CHECK_LE(chunk.last - chunk.first, 8);
    next = chunk.last;
    for (auto e = chunk.first; e < chunk.last; ++e) {
      const core::OffsetEdge& edge = contours.edges()[static_cast<std::size_t>(e)];
      for (const double t : {0.0, 1.0}) {
        CHECK_GE(edge.x + t * edge.dx, chunk.box.min_x);
        CHECK_LE(edge.x + t * edge.dx, chunk.box.max_x);
        CHECK_GE(edge.y + t * edge.dy, chunk.box.min_y);
        CHECK_LE(edge.y + t * edge.dy, chunk.box.max_y);
      }
    }
  }
  CHECK_EQ(static_cast<std::size_t>(next), contours.edges().size());
}

TEST_CASE("the distance between two boxes") {
  const core::OffsetBox a{0, 0, 10, 10};
  CHECK_EQ(a.distance_squared({3, 3, 4, 4}), 0);
  CHECK_EQ(a.distance_squared({13, 2, 20, 5}), 9);
  CHECK_EQ(a.distance_squared({13, 14, 20, 20}), 25);
  CHECK_EQ(a.distance_squared({-9, -4, -3, 20}), 9);
}
