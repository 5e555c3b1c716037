#include "core/regions/convex_hull.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "core/units.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"

using core::Point;
using core::Ring;

namespace {

Ring random_points(test::Random& random) {
  Ring points;
  const int count = random.integer(3, 40), reach = random.integer(2, 30);
  for (int i = 0; i < count; ++i) {
    points.push_back(
        {random.integer(-reach, reach) * 1'000, random.integer(-reach, reach) * 1'000});
  }
  return points;
}

// Of the points, along the direction of an angle.
double extent_mm(const Ring& points, double angle) {
  double least = std::numeric_limits<double>::max(), most = -least;
  for (const Point p : points) {
    const double along = std::cos(angle) * p.x + std::sin(angle) * p.y;
    least = std::min(least, along);
    most = std::max(most, along);
  }
  return (most - least) / core::kUnitsPerMm;
}

}  // namespace

TEST_CASE("a hull turns left at each of its points, which are some of those given, and holds all") {
  for (std::uint64_t seed = 1; seed <= 2'000; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Ring points = random_points(random);
    const Ring hull = core::convex_hull(points);
    if (hull.size() < 3) {
      for (const Point p : points) CHECK_EQ(core::cross(hull.front(), hull.back(), p), 0);
      continue;
    }
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Point a = hull[i], b = hull[(i + 1) % hull.size()];
      CHECK_GT(core::cross(a, b, hull[(i + 2) % hull.size()]), 0);
      CHECK_NE(std::find(points.begin(), points.end(), a), points.end());
      for (const Point p : points) REQUIRE_GE(core::cross(a, b, p), 0);
    }
    CHECK_EQ(hull.front(), *std::min_element(points.begin(), points.end()));
  }
}

TEST_CASE("the least breadth is the least of all directions' extents, the length is across it") {
  constexpr int kDirections = 4'000;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Ring hull = core::convex_hull(random_points(random));
    if (hull.size() < 3) continue;
    double least = std::numeric_limits<double>::max(), largest = 0;
    for (int i = 0; i < kDirections; ++i) {
      const double extent = extent_mm(hull, std::numbers::pi * i / kDirections);
      least = std::min(least, extent);
      largest = std::max(largest, extent);
    }
    const core::Breadth breadth = core::breadth_of(hull);
    // The nearest direction that was tried is half a step away at most.
    CHECK_LE(breadth.least_mm, least + 1e-9);
    CHECK_GE(breadth.least_mm, least - largest * std::numbers::pi / kDirections);
    CHECK_GE(breadth.length_mm, breadth.least_mm - 1e-9);
    CHECK_LE(breadth.length_mm, largest * (1 + 1e-5));
  }
}

TEST_CASE("rectangles, a triangle, and what has no breadth") {
  const core::Breadth plate = core::breadth_of(core::convex_hull(test::rectangle(1, 2, 31, 6)));
  CHECK_EQ(plate.least_mm, doctest::Approx(4));
  CHECK_EQ(plate.length_mm, doctest::Approx(30));
  const Ring triangle = test::rings_from_text("0:0 8:0 0:6").front();
  CHECK_EQ(core::breadth_of(core::convex_hull(triangle)).least_mm, doctest::Approx(4.8));
  CHECK_EQ(core::breadth_of(core::convex_hull(triangle)).length_mm, doctest::Approx(10));
  const Ring line = core::convex_hull({{0, 0}, {5, 5}, {9, 9}, {2, 2}});
  CHECK_EQ(line.size(), 2);
  CHECK_EQ(core::breadth_of(line).least_mm, 0);
}
