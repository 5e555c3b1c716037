#include "core/roads/lower_envelope.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/roads/cell_curves.h"
#include "tests/support/random_regions.h"

using core::CornerCurve;
using core::EdgeCurve;
using core::EnvelopePiece;
using core::LowerEnvelope;
using test::Random;

namespace {

template <typename Curve>
double lowest_at(const std::vector<Curve>& curves, double t) {
  double lowest = std::numeric_limits<double>::max();
  for (const Curve& curve : curves) {
    if (curve.low <= t && t <= curve.high) lowest = std::min(lowest, curve.value(t));
  }
  return lowest;
}

// Pieces cover all, and the named curve is the lowest: at both ends of its piece, and, of two
// curves, all along it.
template <typename Curve>
void check(const std::vector<Curve>& curves, double from, double to, double slack) {
  LowerEnvelope<Curve> envelope;
  const std::vector<EnvelopePiece>& pieces = envelope.find(curves, from, to);
  REQUIRE_FALSE(pieces.empty());
  CHECK_EQ(pieces.back().to, to);
  double start = from;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    CHECK_GE(pieces[i].to, start);
    if (i > 0) CHECK_NE(pieces[i].curve, pieces[i - 1].curve);
    const double length = pieces[i].to - start;
    for (int k = 0; k <= 40; ++k) {
      if (curves.size() > 2 && 0 < k && k < 40) continue;
      // Beside the ends, at which other curves may end as well.
      const double t = start + length * std::clamp(k / 40.0, 1e-9, 1 - 1e-9);
      CHECK(curves[pieces[i].curve].value(t) <= lowest_at(curves, t) + slack);
    }
    start = pieces[i].to;
  }
}

}  // namespace

TEST_CASE("parabolas and lines, as edges and corners give them") {
  for (std::uint64_t seed = 1; seed <= 2'000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<EdgeCurve> curves{{0, 0, 60}};
    for (int i = seed % 3 == 0 ? 1 : random.integer(1, 7); i > 0; --i) {
      // A corner gives a parabola, an edge a straight line.
      const double u = random.between(-20, 120), h = random.between(5, 150);
      EdgeCurve curve{0, random.between(-3, 3), random.between(0, 90)};
      if (random.integer(0, 1) == 1) curve = {1 / (2 * h), -u / h, (u * u + h * h) / (2 * h)};
      if (random.integer(0, 2) == 0) curve.low = random.between(0, 100);
      if (random.integer(0, 2) == 0) curve.high = std::max(curve.low, random.between(0, 100));
      curves.push_back(curve);
    }
    check(curves, 0, 100, 10 * EdgeCurve::kSame);
  }
}

TEST_CASE("curves about a reflex corner") {
  for (std::uint64_t seed = 1; seed <= 2'000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<CornerCurve> curves{{1.0 / 50, 0, 0}};
    for (int i = seed % 3 == 0 ? 1 : random.integer(1, 7); i > 0; --i) {
      const double angle = random.between(-2, 2), distance = random.between(10, 200);
      // Another corner, or an edge with its normal.
      CornerCurve curve{0, 2 / distance * std::cos(angle), 2 / distance * std::sin(angle)};
      if (random.integer(0, 1) == 1) {
        curve = {1 / distance, -std::cos(angle) / distance, -std::sin(angle) / distance};
      }
      curves.push_back(curve);
    }
    check(curves, -1.5, 1.5, 10 * CornerCurve::kSame);
  }
}

TEST_CASE("one curve alone, and two that cross once") {
  LowerEnvelope<EdgeCurve> envelope;
  const std::vector<EdgeCurve> one{{0, 1, 0}};
  REQUIRE_EQ(envelope.find(one, 2, 5).size(), 1);
  CHECK_EQ(envelope.find(one, 2, 5).front().to, 5);
  const std::vector<EdgeCurve> two{{0, 1, 0}, {0, -1, 10}};
  const auto pieces = envelope.find(two, 0, 10);
  REQUIRE_EQ(pieces.size(), 2);
  CHECK_EQ(pieces[0].curve, 0);
  CHECK_EQ(pieces[0].to, doctest::Approx(5));
  CHECK_EQ(pieces[1].curve, 1);
}
