#include "core/offsets/offset_runs.h"

#include <doctest/doctest.h>

#include <vector>

#include "tests/support/grid_regions.h"
#include "tests/support/offset_elements.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"

using core::OffsetCorner;
using core::OffsetEdge;
using core::OffsetInput;
using core::Region;
using test::Random;

namespace {

// The part of an edge's line that its neighbours leave at this depth.
struct Left {
  double from = 0, to = 0;
};

Left left_by_neighbours(const OffsetInput& contours, std::size_t i, double depth) {
  const OffsetEdge& edge = contours.edges()[i];
  const OffsetCorner& start = contours.corners()[i];
  const OffsetCorner& end = contours.corners()[static_cast<std::size_t>(edge.end_corner)];
  return {start.reflex ? 0 : depth * start.half_tangent,
          edge.length - (end.reflex ? 0 : depth * end.half_tangent)};
}

// Points of the elements of all edges, and how near the other edges of the same run come to them.
void check_runs(const Region& region, bool mirrored, double deepest, int& in_runs) {
  OffsetInput contours;
  contours.load(region, mirrored);
  core::find_runs(contours, deepest);
  for (const double depth : {deepest, 0.3 * deepest}) {
    for (std::size_t i = 0; i < contours.edges().size(); ++i) {
      const Left left = left_by_neighbours(contours, i, depth);
      for (int k = 0; k <= 8 && left.from < left.to; ++k) {
        const test::ElementPoint p =
            test::on_line(contours, i, left.from + (left.to - left.from) * k / 8, depth);
        for (std::size_t other = 0; other < contours.edges().size(); ++other) {
          if (other == i || contours.edges()[other].run != contours.edges()[i].run) continue;
          ++in_runs;
          CHECK_GE(test::distance_to_edge(contours.edges()[other], p), depth - 1e-6);
        }
      }
      if (!contours.corners()[i].reflex) continue;
      const auto before = static_cast<std::size_t>(contours.edges()[i].previous);
      if (contours.edges()[before].run != contours.edges()[i].run) continue;
      for (int k = 0; k <= 4; ++k) {
        const test::ElementPoint p = test::on_arc(contours, i, k / 4.0, depth);
        for (const OffsetEdge& other : contours.edges()) {
          if (other.run != contours.edges()[i].run) continue;
          CHECK_GE(test::distance_to_edge(other, p), depth - 1e-6);
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("edges of one run cover nothing of one another's elements, whatever the depth") {
  int in_runs = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = seed % 3 == 0 ? test::random_grid_region(random, 1'000)
                                        : test::random_region(random, 60, 20);
    for (const double deepest : {300.0, 2'000.0, 9'000.0}) {
      check_runs(region, false, deepest, in_runs);
      check_runs(region, true, deepest, in_runs);
    }
  }
  CHECK_GT(in_runs, 10'000);
}

TEST_CASE("a convex contour is one run from outside, and from inside as long as all edges stay") {
  const Region octagon = test::region_from_text("3:0 7:0 10:3 10:7 7:10 3:10 0:7 0:3");
  const auto runs = [&](bool mirrored, double deepest) {
    OffsetInput contours;
    contours.load(octagon, mirrored);
    core::find_runs(contours, deepest);
    std::vector<std::int32_t> all;
    for (const OffsetEdge& edge : contours.edges()) all.push_back(edge.run);
    return all;
  };
  CHECK_EQ(runs(true, 1e6), std::vector<std::int32_t>(8, 0));
  CHECK_EQ(runs(false, 40'000), std::vector<std::int32_t>(8, 0));
  CHECK_NE(runs(false, 60'000), std::vector<std::int32_t>(8, 0));
}
