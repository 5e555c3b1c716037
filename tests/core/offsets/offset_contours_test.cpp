#include "core/offsets/offset_contours.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/random_regions.h"

using core::Length;
using core::OffsetContour;
using core::OffsetPiece;
using core::Point;
using test::Random;

namespace {

Point on_circle(Point centre, double radius, double angle) {
  return {static_cast<std::int32_t>(std::lround(centre.x + radius * std::cos(angle))),
          static_cast<std::int32_t>(std::lround(centre.y + radius * std::sin(angle)))};
}

double distance(Point a, Point b) {
  return std::hypot(static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y);
}

}  // namespace

TEST_CASE("an arc becomes as few chords as the tolerance allows, evenly along it") {
  int many = 0;
  for (std::uint64_t seed = 1; seed <= 20'000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Point centre{random.integer(-1'000, 1'000), random.integer(-1'000, 1'000)};
    const double radius = std::exp(random.integer(4'000, 16'000) / 1e3);
    const double start = random.integer(0, 6'283) / 1e3, sweep = random.integer(1, 3'100) / 1e3;
    const int coarse = std::min(60, static_cast<int>(radius / 4));
    const Length tolerance = Length::from_units(random.integer(1, coarse));
    const Point a = on_circle(centre, radius, start);
    const Point b = on_circle(centre, radius, start + sweep);
    if (a == b) continue;
    // A slice of a pie.
    const OffsetContour pie = {{a, OffsetPiece::Kind::kArcCounterClockwise, centre},
                               {b, OffsetPiece::Kind::kLine, {}},
                               {centre, OffsetPiece::Kind::kLine, {}}};
    const core::Region region = core::flatten({pie}, tolerance);
    if (core::cross(a, b, centre) == 0) continue;
    REQUIRE_EQ(region.rings().size(), 1u);
    const core::Ring& ring = region.rings()[0];
    const double longest = std::max(distance(a, centre), distance(b, centre));
    const double of_chord =
        2 * std::acos(std::max(0.0, 1 - static_cast<double>(tolerance.units()) / longest));
    const double ax = a.x - centre.x, ay = a.y - centre.y, bx = b.x - centre.x, by = b.y - centre.y;
    const double turn = std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    const double wanted = std::ceil(turn / of_chord - 1e-9);
    CHECK_EQ(static_cast<double>(ring.size()), std::max(1.0, wanted) + 2);
    many += ring.size() > 8 ? 1 : 0;
    const auto first = std::find(ring.begin(), ring.end(), a);
    REQUIRE(first != ring.end());
    const auto at = [&](std::size_t i) {
      return ring[(static_cast<std::size_t>(first - ring.begin()) + i) % ring.size()];
    };
    CHECK_EQ(at(ring.size() - 2), b);
    for (std::size_t i = 0; i + 2 < ring.size(); ++i) {
      CHECK(distance(at(i), centre) == doctest::Approx(radius).epsilon(1.5 / radius));
      const double chord = 2 * radius * std::sin(turn / (2 * std::max(1.0, wanted)));
      CHECK(std::abs(distance(at(i), at(i + 1)) - chord) < 2.5);
    }
  }
  CHECK_GT(many, 1'000);
}

TEST_CASE("ends that rounding has turned round are no arc") {
  // About (0, 0), from one end to the other it would go nearly all the way round.
  const OffsetContour turned = {{{1000, 1}, OffsetPiece::Kind::kArcCounterClockwise, {0, 0}},
                                {{1000, 0}, OffsetPiece::Kind::kLine, {}},
                                {{1000, 0}, OffsetPiece::Kind::kLine, {}},
                                {{500, 900}, OffsetPiece::Kind::kLine, {}},
                                {{400, 100}, OffsetPiece::Kind::kLine, {}},
                                {{1000, 1}, OffsetPiece::Kind::kLine, {}}};
  const core::Region region = core::flatten({turned}, Length::from_units(25));
  for (const core::Ring& ring : region.rings()) {
    CHECK_LE(ring.size(), 4u);
  }
}
