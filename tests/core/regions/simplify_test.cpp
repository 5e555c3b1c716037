#include "core/regions/simplify.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Length;
using core::Point;
using core::Ring;
using core::simplify;

namespace {

Ring circle(double radius, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back({static_cast<std::int32_t>(std::lround(radius * std::cos(angle))),
                    static_cast<std::int32_t>(std::lround(radius * std::sin(angle)))});
  }
  return ring;
}

}  // namespace

TEST_CASE("points on straight lines go, corners stay") {
  const Ring square = test::rectangle(0, 0, 1, 1);
  Ring with_more;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = square[i], b = square[(i + 1) % 4];
    for (int k = 0; k < 10; ++k) {
      with_more.push_back({a.x + (b.x - a.x) / 10 * k, a.y + (b.y - a.y) / 10 * k});
    }
  }
  CHECK_EQ(simplify(with_more, Length::from_units(0)), square);
  CHECK_EQ(simplify(with_more, Length::from_units(1)), square);
  CHECK_EQ(simplify(with_more, Length::from_units(50)), square);
}

TEST_CASE("points rounded to the grid beside a slanted line go, wherever they are") {
  // A polygon with edges in all directions; points on its edges, rounded.
  const Ring polygon = simplify(circle(100'000, 37), Length::from_units(1));
  REQUIRE_EQ(polygon.size(), 37);
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    Ring ring;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      ring.push_back(a);
      const double share = random.between(0.05, 0.95);
      ring.push_back({static_cast<std::int32_t>(std::lround(a.x + share * (b.x - a.x))),
                      static_cast<std::int32_t>(std::lround(a.y + share * (b.y - a.y)))});
    }
    std::rotate(ring.begin(), ring.begin() + random.integer(0, 73), ring.end());
    CHECK_EQ(simplify(ring, Length::from_units(1)), polygon);
    CHECK_EQ(simplify(ring, Length::from_units(50)), polygon);
  }
}

TEST_CASE("nothing is moved by more than the tolerance, and less is left the larger it is") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    test::Random random(seed);
    const Ring ring = seed % 2 == 0 ? test::random_blob(random, 400, 0, 0, 5, 0.3)
                                    : test::random_ring(random, 30, 0.05);
    for (const std::int64_t tolerance : {0, 1, 5, 50, 500}) {
      CAPTURE(seed);
      CAPTURE(tolerance);
      const Ring result = simplify(ring, Length::from_units(tolerance));
      if (result.empty()) continue;
      for (const Point p : ring) {
        CHECK(test::distance_to_boundary({result}, p.x, p.y) <=
              static_cast<double>(tolerance) + 1.0 + 1e-6);
      }
      for (const Point p : result) CHECK(std::find(ring.begin(), ring.end(), p) != ring.end());
      CHECK_EQ(result.front(), *std::min_element(result.begin(), result.end()));
    }
  }
}

TEST_CASE("a fine circle keeps as many points as the tolerance asks for") {
  // n chords of a circle stay within r (1 − cos(π/n)): 50 units at 100,000 are met by 100 points.
  const Ring ring = circle(100'000, 5'000);
  const Ring result = simplify(ring, Length::from_units(50));
  CHECK(result.size() >= 100);
  CHECK(result.size() <= 200);
}

TEST_CASE("it does not matter where a ring starts") {
  test::Random random(7);
  Ring ring = test::random_blob(random, 300, 0, 0, 5, 0.3);
  const Ring expected = simplify(ring, Length::from_units(50));
  for (int i = 0; i < 20; ++i) {
    std::rotate(ring.begin(), ring.begin() + random.integer(1, 299), ring.end());
    CHECK_EQ(simplify(ring, Length::from_units(50)), expected);
  }
}

TEST_CASE("the points it starts from are left out like others") {
  // The lowest point stands out by less than the tolerance.
  const Ring square = test::rectangle(0, 0, 1, 1);
  Ring ring = square;
  ring.push_back({-30, 5'000});
  CHECK_EQ(simplify(ring, Length::from_units(50)), square);
  CHECK_EQ(simplify(ring, Length::from_units(20)).size(), 5);
}

TEST_CASE("what has no area vanishes") {
  CHECK(simplify({}, Length::from_units(50)).empty());
  CHECK(simplify({{0, 0}, {0, 0}, {0, 0}}, Length::from_units(50)).empty());
  CHECK(simplify({{0, 0}, {100, 0}}, Length::from_units(50)).empty());
  CHECK(simplify({{0, 0}, {100, 0}, {50, 0}}, Length::from_units(0)).empty());
  CHECK(simplify(circle(20, 12), Length::from_units(50)).empty());
}
