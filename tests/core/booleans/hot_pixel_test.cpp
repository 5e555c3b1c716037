#include "core/booleans/hot_pixel.h"

#include <doctest/doctest.h>

#include "core/limits.h"
#include "tests/support/random_regions.h"

using core::Point;
using test::Random;

namespace {

__extension__ using Int128 = __int128;

Int128 rounded_down(Int128 numerator, Int128 denominator) {
  const Int128 quotient = numerator / denominator;
  return quotient * denominator > numerator ? quotient - 1 : quotient;
}

// The pixel of a + (b − a) · part / whole.
Point pixel_along(Point a, Point b, Int128 part, Int128 whole) {
  const auto round = [&](std::int64_t start, std::int64_t step) {
    return static_cast<std::int32_t>(start + rounded_down(2 * step * part + whole, 2 * whole));
  };
  return {round(a.x, std::int64_t{b.x} - a.x), round(a.y, std::int64_t{b.y} - a.y)};
}

Point random_point(Random& random, int size) {
  return {random.integer(-size, size), random.integer(-size, size)};
}

}  // namespace

TEST_CASE("an edge passes just the pixels in which it has a point") {
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    const Point a = random_point(random, 6), b = random_point(random, 6);
    if (a == b) continue;
    bool passed[17][17] = {};
    // An edge enters and leaves pixels at multiples of 1 / (2 dx) and 1 / (2 dy) of its length,
    // with dx, dy <= 12: all of them are among these points, and a point between any two of them.
    constexpr int kSteps = 4 * 27'720;
    for (int k = 0; k <= kSteps; ++k) {
      const Point p = pixel_along(a, b, k, kSteps);
      passed[p.x + 8][p.y + 8] = true;
    }
    for (std::int32_t x = -8; x <= 8; ++x) {
      for (std::int32_t y = -8; y <= 8; ++y) {
        INFO(a.x, ":", a.y, " -> ", b.x, ":", b.y, " at ", x, ":", y);
        CHECK_EQ(core::passes_pixel(a, b, {x, y}), passed[x + 8][y + 8]);
      }
    }
  }
}

TEST_CASE("crossings fall into the pixel of the exact crossing") {
  Random random(2);
  for (const int size : {3, 40, 1'000'000, int{core::kCoordinateMax}}) {
    for (int i = 0; i < 20'000; ++i) {
      const Point a = random_point(random, size), b = random_point(random, size);
      const Point c = random_point(random, size), d = random_point(random, size);
      const Int128 at_a = core::cross(c, d, a), at_b = core::cross(c, d, b);
      const Int128 at_c = core::cross(a, b, c), at_d = core::cross(a, b, d);
      if (at_a * at_b >= 0 || at_c * at_d >= 0) continue;
      const Int128 whole = at_a > 0 ? at_a - at_b : at_b - at_a;
      const Point exact = pixel_along(a, b, at_a > 0 ? at_a : -at_a, whole);
      const Point pixel = core::crossing_pixel(a, b, c, d);
      CHECK((pixel == exact));
      CHECK((core::crossing_pixel(d, c, a, b) == exact));
      CHECK(core::passes_pixel(a, b, pixel));
      CHECK(core::passes_pixel(c, d, pixel));
    }
  }
}
