#include "core/regions/ring_corners.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "core/regions/corner_index.h"
#include "core/regions/polyline.h"
#include "core/trigonometry.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

const Length kArm = Length::from_mm(0.7);

Ring circle(double radius_mm, int points) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    ring.push_back({static_cast<std::int32_t>(std::lround(radius_mm * 1e4 * cosine(angle))),
                    static_cast<std::int32_t>(std::lround(radius_mm * 1e4 * sine(angle)))});
  }
  return ring;
}

}  // namespace

TEST_CASE("an L has five corners to the left and one to the right") {
  const Ring ring = test::region_from_text("0:0 20:0 20:10 10:10 10:20 0:20").rings().front();
  const auto corners = ring_corners(ring, kArm);
  REQUIRE_EQ(corners.size(), 6);
  int right = 0;
  for (const RingCorner& corner : corners) {
    CHECK_EQ(ring[corner.place.edge], corner.place.at);
    CHECK(std::abs(corner.turn) == doctest::Approx(std::numbers::pi / 2));
    if (corner.turn > 0) continue;
    ++right;
    CHECK_EQ(corner.place.at, (Point{100'000, 100'000}));
  }
  CHECK_EQ(right, 1);
}

TEST_CASE("a small round is one corner, a circle none, however fine or small") {
  for (const double radius_mm : {0.5, 1.0, 3.0, 30.0}) {
    for (const int points : {24, 96, 500}) {
      CAPTURE(radius_mm);
      CAPTURE(points);
      CHECK(ring_corners(circle(radius_mm, points), kArm).empty());
    }
  }
  // A square of 10 mm whose first corner is rounded by 0.3 mm.
  Ring rounded;
  for (const Point p : circle(0.3, 40)) {
    if (p.x <= 0 && p.y <= 0) rounded.push_back({p.x + 3'000, p.y + 3'000});
  }
  for (const Point p : {Point{100'000, 0}, {100'000, 100'000}, {0, 100'000}}) rounded.push_back(p);
  CHECK_EQ(ring_corners(rounded, kArm).size(), 4);
}

TEST_CASE("the nearest place is as near as any, on the ring, and its own nearest place") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Ring ring = test::random_blob(random, 60, 0, 0, 8, 0.6);
    for (int i = 0; i < 50; ++i) {
      const Point to{random.integer(-120'000, 120'000), random.integer(-120'000, 120'000)};
      const RingPlace place = nearest_place(ring, to);
      const Point a = ring[place.edge], b = ring[(place.edge + 1) % ring.size()];
      CHECK_LE(distance_units(a, place.at) + distance_units(place.at, b) - distance_units(a, b), 2);
      const double away = distance_units(place.at, to);
      for (std::size_t k = 0; k < ring.size(); ++k) {
        for (int part = 0; part < 20; ++part) {
          const Point p = between(ring[k], ring[(k + 1) % ring.size()], part / 20.0);
          REQUIRE_LE(away, distance_units(p, to) + 1);
        }
      }
      CHECK_EQ(nearest_place(ring, place.at).at, place.at);
    }
  }
}

TEST_CASE("an index finds the nearest corner of the same side, as a search through all does") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 200, 30);
    const CornerIndex index(region, kArm);
    std::vector<RingCorner> all;
    for (const Ring& ring : region.rings()) {
      for (const RingCorner& corner : ring_corners(ring, kArm)) all.push_back(corner);
    }
    for (int i = 0; i < 200; ++i) {
      const Point to{random.integer(-50'000, 350'000), random.integer(-50'000, 350'000)};
      const double turn = i % 2 == 0 ? 1 : -1;
      const Length reach = Length::from_mm(random.between(0.5, 6));
      std::optional<double> least;
      for (const RingCorner& corner : all) {
        const double away = distance_units(corner.place.at, to);
        if ((corner.turn < 0) != (turn < 0) || away > static_cast<double>(reach.units())) continue;
        if (!least || away < *least) least = away;
      }
      const auto found = index.nearest(to, turn, reach);
      REQUIRE_EQ(found.has_value(), least.has_value());
      if (found) CHECK_EQ(distance_units(found->at, to), *least);
    }
  }
}
