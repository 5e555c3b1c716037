#include "core/offsets/arc_polygon.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/rounded.h"

namespace core {
namespace {

constexpr double kTolerance = 25;
// What rounding of a vertex to the grid adds. Units.
constexpr double kRounding = 2;

Vector on_circle(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// About a centre, of rounded ends.
struct Case {
  Arc arc;
  double radius;
  double start, sweep;  // the sweep is negative for clockwise

  // A point on the line that touches the arc at its start, or its end, so far outside the arc.
  [[nodiscard]] Point beyond(bool end, double length) const {
    const double side = sweep > 0 ? 1 : -1, angle = end ? start + sweep : start;
    const Vector along = left_of(on_circle(1, angle)) * (end ? side : -side);
    return rounded(arc.centre + on_circle(radius, angle) + along * length);
  }
};

Case arc_case(Vector centre, double radius, double start, double sweep) {
  const auto end_of = [&](double angle) {
    return to_vector(rounded(centre + on_circle(radius, angle))) - centre;
  };
  return {
      {centre, end_of(start), end_of(start + sweep), sweep > 0 ? 1.0 : -1.0}, radius, start, sweep};
}

double distance_to_centre(const Arc& arc, Point p) {
  const Vector way = to_vector(p) - arc.centre;
  return std::sqrt(dot(way, way));
}

// From the centre to the segment.
double least_to_centre(const Arc& arc, Point a, Point b) {
  const Vector from = to_vector(a), along = to_vector(b) - from;
  const Vector nearest = from + along * share_along(arc.centre - from, along) - arc.centre;
  return std::sqrt(dot(nearest, nearest));
}

}  // namespace

TEST_CASE("random arcs between lines: vertices and edges within the tolerance, few of them") {
  ArcPolygon polygon(kTolerance);
  int replaced = 0, chord_points = 0;
  for (std::uint64_t seed = 1; seed <= 2'000; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const auto any = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    const double radius = std::exp(any(std::log(300.0), std::log(200'000.0)));
    const double sweep = any(0.01, 3) * (any(0, 1) < 0.5 ? 1 : -1);
    const Case one = arc_case({std::round(any(-1e6, 1e6)), std::round(any(-1e6, 1e6))}, radius,
                              any(0, 2 * std::numbers::pi), sweep);
    const Point before = one.beyond(false, 50'000), after = one.beyond(true, 50'000);
    Ring ring{before};
    REQUIRE(polygon.add_between(before, one.arc, after, ring));
    ring.push_back(after);
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
      CHECK_GE(least_to_centre(one.arc, ring[i], ring[i + 1]), radius - kTolerance - kRounding);
      if (i == 0) continue;
      CHECK_LE(distance_to_centre(one.arc, ring[i]), radius + kTolerance + kRounding);
      CHECK_GE(distance_to_centre(one.arc, ring[i]), radius - kRounding);
    }
    replaced += static_cast<int>(ring.size()) - 2;
    Ring chords;
    polygon.add_chords(one.arc, chords);
    for (const Point p : chords) {
      CHECK_EQ(distance_to_centre(one.arc, p), doctest::Approx(radius).epsilon(2 / radius));
    }
    chord_points += static_cast<int>(chords.size()) + 2;
  }
  CHECK_LT(replaced, chord_points * 3 / 4);
}

TEST_CASE("a small arc is one vertex, where its lines meet") {
  const Case one = arc_case({0, 0}, 6'000, 0, 0.1);
  Ring ring;
  CHECK(ArcPolygon(kTolerance)
            .add_between(one.beyond(false, 9'000), one.arc, one.beyond(true, 9'000), ring));
  REQUIRE_EQ(ring.size(), 1);
  CHECK_EQ(ring[0], rounded(on_circle(6'000 / std::cos(0.05), 0.05)));
}

TEST_CASE("a line that does not touch the arc: nothing is added") {
  const Case one = arc_case({0, 0}, 6'000, 0.3, 1);
  const Point before = one.beyond(false, 9'000), after = one.beyond(true, 9'000);
  Ring ring{{1, 2}};
  const auto added = [&](Point from, Point to) {
    return ArcPolygon(kTolerance).add_between(from, one.arc, to, ring);
  };
  CHECK_FALSE(added({before.x + 400, before.y}, after));
  CHECK_FALSE(added(before, {after.x - 400, after.y}));
  CHECK_EQ(ring, Ring{{1, 2}});
}

}  // namespace core
