#include "core/regions/segment_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "core/roads/nearest_point.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

Point random_point(test::Random& random, int range) {
  return {random.integer(-range, range), random.integer(-range, range)};
}

int side(Point a, Point b, Point c) {
  const auto turn = cross(a, b, c);
  return (turn > 0) - (turn < 0);
}

// Proper crossings only: random segments don't touch.
bool crossing(const Segment& a, const Segment& b) {
  return side(a.from, a.to, b.from) * side(a.from, a.to, b.to) < 0 &&
         side(b.from, b.to, a.from) * side(b.from, b.to, a.to) < 0;
}

}  // namespace

TEST_CASE("a grid of segments agrees with asking every segment") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Length cell = Length::from_units(random.integer(1, 5'000));
    std::vector<Segment> segments;
    for (int i = 0; i < 40; ++i) {
      const Point a = random_point(random, 20'000);
      const Segment s{a,
                      {a.x + random.integer(-3'000, 3'000), a.y + random.integer(-3'000, 3'000)}};
      segments.push_back(s);
    }
    const SegmentGrid grid(cell, segments);
    for (int i = 0; i < 100; ++i) {
      const Point p = random_point(random, 22'000);
      const int reach = random.integer(1, 4'000);
      const bool near = std::any_of(segments.begin(), segments.end(), [&](const Segment& s) {
        return test::distance_to_segment(p, s) <= reach;
      });
      CHECK_EQ(grid.any_within(p, Length::from_units(reach)), near);
      const Segment line{p, random_point(random, 22'000)};
      const bool crosses = std::any_of(segments.begin(), segments.end(),
                                       [&](const Segment& s) { return crossing(s, line); });
      CHECK_EQ(grid.crosses(line), crosses);
    }
  }
}

TEST_CASE("a line that only touches a contour, or runs along it, crosses it") {
  const SegmentGrid grid(Length::from_mm(1), test::region_from_text("0:0 10:0 10:10 0:10"));
  CHECK(grid.crosses({{-50'000, 0}, {150'000, 0}}));
  CHECK(grid.crosses({{50'000, 50'000}, {100'000, 50'000}}));
  CHECK(grid.crosses({{20'000, 0}, {30'000, 0}}));
  CHECK_FALSE(grid.crosses({{1, 1}, {99'999, 99'999}}));
  CHECK_FALSE(grid.crosses({{110'000, 0}, {110'000, 100'000}}));
}

TEST_CASE("the nearest point agrees with asking every point, while owners leave") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<NearestPoint::Entry> left;
    const int flat = seed % 4 == 0 ? 0 : 1;  // all in one line
    for (std::size_t owner = 0; owner < 30; ++owner) {
      for (std::size_t place = 0; place <= owner % 3; ++place) {
        left.push_back(
            {{random.integer(-9'000, 9'000), flat * random.integer(-9'000, 9'000)}, owner, place});
      }
    }
    NearestPoint points(left);
    while (!left.empty()) {
      const Point at = random_point(random, 30'000);
      const auto distance2 = [&](const NearestPoint::Entry& e) {
        const double dx = e.point.x - at.x, dy = e.point.y - at.y;
        return dx * dx + dy * dy;
      };
      const auto best = std::min_element(
          left.begin(), left.end(),
          [&](const auto& a, const auto& b) { return distance2(a) < distance2(b); });
      const auto found = points.nearest(at);
      REQUIRE(found.has_value());
      CHECK_EQ(distance2(*found), distance2(*best));
      const std::size_t owner = found->owner;
      points.remove_owner(owner);
      std::erase_if(left, [&](const NearestPoint::Entry& e) { return e.owner == owner; });
    }
    CHECK_FALSE(points.nearest({0, 0}).has_value());
  }
}

TEST_CASE("no points at all") { CHECK_FALSE(NearestPoint({}).nearest({0, 0}).has_value()); }
