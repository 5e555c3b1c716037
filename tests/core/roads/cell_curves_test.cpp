#include "core/roads/cell_curves.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random_regions.h"

using core::CornerCurve;
using core::EdgeCurve;
using test::Random;

namespace {

// The parameter where other − curve is least, by looking at many.
template <typename Curve>
double least_difference(const Curve& curve, const Curve& other, double from, double to) {
  double least = other.value(from) - curve.value(from);
  for (int k = 1; k <= 2'000; ++k) {
    const double t = from + (to - from) * k / 2'000;
    least = std::min(least, other.value(t) - curve.value(t));
  }
  return least;
}

template <typename Curve>
void check_pair(const Curve& a, const Curve& b, double from, double to, double slack) {
  const double at = a.closest(b, typename Curve::Place(from), typename Curve::Place(to));
  CHECK_GE(at, from);
  CHECK_LE(at, to);
  CHECK(b.value(at) - a.value(at) <= least_difference(a, b, from, to) + slack);
  // Where one is lower at one end and the other one at the other, they cross.
  const double first = b.value(from) - a.value(from), last = b.value(to) - a.value(to);
  if (first * last >= 0) return;
  const double crossing = a.crossing(b, from, to);
  CHECK_GE(crossing, from);
  CHECK_LE(crossing, to);
  CHECK(std::abs(a.value(crossing) - b.value(crossing)) <= slack);
}

}  // namespace

TEST_CASE("a disc on an edge touches another corner: the parabola is its radius") {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    // The edge is the x axis; the corner is at (u, h).
    const double u = random.between(-50, 150), h = random.between(1, 80);
    const EdgeCurve curve{1 / (2 * h), -u / h, (u * u + h * h) / (2 * h)};
    const double t = random.between(0, 100), r = curve.value(t);
    CHECK(std::hypot(t - u, r - h) == doctest::Approx(r));
  }
}

TEST_CASE("discs at a reflex corner touch another corner, or an edge: the curve is −1 / radius") {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const double x = random.between(-40, 40), y = random.between(-40, 40);
    const double share = 2 / (x * x + y * y), angle = random.between(-3, 3);
    const CornerCurve corner{0, share * x, share * y};
    if (corner.value(angle) < -1e-3) {
      const double r = -1 / corner.value(angle);
      CHECK(std::hypot(r * std::cos(angle) - x, r * std::sin(angle) - y) == doctest::Approx(r));
    }
    // An edge h away, its normal towards the corner at `normal`.
    const double normal = random.between(-3, 3), h = random.between(1, 60);
    const CornerCurve edge{1 / h, -std::cos(normal) / h, -std::sin(normal) / h};
    if (edge.value(angle) > -1e-3) continue;
    const double r = -1 / edge.value(angle);
    CHECK(h + r * std::cos(angle - normal) == doctest::Approx(r));
  }
}

TEST_CASE("crossings and least differences of edge curves are what sampling finds") {
  for (std::uint64_t seed = 1; seed <= 1'000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const auto curve = [&]() -> EdgeCurve {
      const double u = random.between(-50, 150), h = random.between(2, 80);
      if (random.integer(0, 1) == 0) return {0, random.between(-2, 2), random.between(0, 80)};
      return {1 / (2 * h), -u / h, (u * u + h * h) / (2 * h)};
    };
    check_pair(curve(), curve(), 0, 100, 1e-6);
  }
}

TEST_CASE("crossings and least differences of corner curves are what sampling finds") {
  for (std::uint64_t seed = 1; seed <= 1'000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const auto curve = [&]() -> CornerCurve {
      return {random.between(0, 0.1), random.between(-0.1, 0.1), random.between(-0.1, 0.1)};
    };
    check_pair(curve(), curve(), -1.5, 1.5, 1e-9);
  }
}

TEST_CASE("the angles at which a cosine and a sine part reach a value") {
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    const double x = random.between(-2, 2), y = random.between(-2, 2);
    const double value = random.between(-0.99, 0.99) * std::hypot(x, y);
    const auto [first, second] = CornerCurve::angles_where(x, y, value);
    for (const double angle : {first, second}) {
      CHECK_LE(std::abs(angle), std::acos(-1.0) + 1e-12);
      CHECK(x * std::cos(angle) + y * std::sin(angle) == doctest::Approx(value).epsilon(1e-9));
    }
  }
}
