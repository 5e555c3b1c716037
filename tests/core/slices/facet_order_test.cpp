// Slices don't depend on the order in which facets come.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/slices/plane_crossing.h"
#include "core/slices/plane_sweep.h"
#include "tests/support/mesh.h"
#include "tests/support/random_regions.h"

using core::Point;
using core::Slice;
using core::Triangle;
using core::Vertex;
using test::exact_options;
using test::part_named;
using test::sweep;
using test::triangles_of;

TEST_CASE("the order of the triangles and of their corners does not matter") {
  for (const parts::Part& part :
       {parts::demo(), parts::lattice(3), part_named("hole"), part_named("crossing_boxes"),
        part_named("flipped_some"), part_named("doubled")}) {
    std::vector<Triangle> triangles = triangles_of(part);
    const std::vector<Slice> expected = sweep(triangles, exact_options()).slices;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      CAPTURE(seed);
      test::Random random(seed);
      test::shuffle(triangles, random);
      for (Triangle& t : triangles) {
        std::rotate(t.corners.begin(), t.corners.begin() + random.integer(0, 2), t.corners.end());
      }
      const std::vector<Slice> slices = sweep(triangles, exact_options()).slices;
      REQUIRE_EQ(slices.size(), expected.size());
      for (std::size_t i = 0; i < slices.size(); ++i) {
        CHECK_EQ(slices[i].region, expected[i].region);
        CHECK_EQ(slices[i].defects.closed_chains, expected[i].defects.closed_chains);
      }
    }
  }
}

TEST_CASE("which of two facets leaves a segment that both have does not depend on their order") {
  // An upright wall between (0, 0) and (20,003, 7,777), cut along its diagonal at a point that
  // rounding moves off it; over each of its facets a slanted one with the same cut.
  const std::array<Point, 4> foot{{{0, 0}, {20'003, 7'777}, {9'001, 30'011}, {-8'003, 21'001}}};
  std::vector<Triangle> prism;
  for (std::size_t i = 0; i < foot.size(); ++i) {
    const Point p = foot[i], q = foot[(i + 1) % foot.size()];
    const Vertex p0{p.x, p.y, 0}, p1{p.x, p.y, 10'000}, q0{q.x, q.y, 0}, q1{q.x, q.y, 10'000};
    prism.push_back({{p0, q0, q1}});
    prism.push_back({{p0, q1, p1}});
  }
  // At the plane of layer 0, 1,000 units up.
  const Point on_diagonal = core::plane_crossing({0, 0, 0}, {20'003, 7'777, 10'000}, 2'000);
  const auto slanted = [](Point from, Point to) {
    const Point top{from.x + 400, from.y - 900};
    return Triangle{{Vertex{top.x, top.y, 2'000}, Vertex{2 * from.x - top.x, 2 * from.y - top.y, 0},
                     Vertex{2 * to.x - top.x, 2 * to.y - top.y, 0}}};
  };
  const Point corner{0, 0},
      far_corner = core::plane_crossing({20'003, 7'777, 0}, {20'003, 7'777, 10'000}, 2'000);
  core::PlaneSweep::Options options = exact_options();
  options.simplify_tolerance = core::Length();  // leaves points that are a little off a line
  for (const Triangle& doubled : {slanted(on_diagonal, far_corner), slanted(corner, on_diagonal)}) {
    std::vector<Triangle> first = prism, last = prism;
    first.insert(first.begin(), doubled);
    last.push_back(doubled);
    const Slice a = sweep(first, options).slices.front();
    const Slice b = sweep(last, options).slices.front();
    CHECK_EQ(a.defects.doubled_facets, 1);
    CHECK_EQ(b.defects.doubled_facets, 1);
    CHECK_EQ(a.region, b.region);
  }
}
