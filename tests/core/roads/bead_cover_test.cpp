#include "core/roads/bead_cover.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Length;
using core::Point;
using core::Region;
using core::Road;
using core::RoadKind;
using test::Random;

namespace {

const Region kPlate = test::region_from_text("-20:-20 20:-20 20:20 -20:20");

struct Nearness {
  double distance = std::numeric_limits<double>::max();  // from the road, in units
  bool beside = false;                                   // of a piece, not only of an end
};

Nearness nearness(const Road& road, double x, double y) {
  Nearness result;
  const std::size_t count = road.points.size();
  for (std::size_t i = 0; i + (road.closed ? 0 : 1) < count; ++i) {
    const Point a = road.points[i], b = road.points[(i + 1) % count];
    const double dx = double(b.x) - a.x, dy = double(b.y) - a.y;
    const double length2 = dx * dx + dy * dy;
    if (length2 == 0) continue;
    const double t = ((x - a.x) * dx + (y - a.y) * dy) / length2;
    const double at = std::clamp(t, 0.0, 1.0);
    const double distance = std::hypot(x - a.x - at * dx, y - a.y - at * dy);
    if (distance >= result.distance) continue;
    // Beyond the open ends, which are cut off square, is not beside.
    const bool beyond = !road.closed && ((i == 0 && t < 0) || (i + 2 == count && t > 1));
    result = {distance, !beyond};
  }
  return result;
}

// Holds every raster point against the distance from the road; returns how many it looked at.
int check_cover(const Road& road, Length width) {
  const Region left = core::uncovered(kPlate, {road}, width);
  CHECK(test::is_clean(left));
  const double half = static_cast<double>(width.units()) / 2;
  int looked = 0, wrong = 0;
  for (double x = -150'017.3; x < 150'000; x += 1'931) {
    for (double y = -150'011.7; y < 150'000; y += 1'949) {
      const Nearness near = nearness(road, x, y);
      const bool covered = test::winding_number(left.rings(), x, y) == 0;
      // A round side's corners reach farther, by 1 / cos 22.5°; two units are rounding's.
      const bool must = near.beside && near.distance < half - 2;
      const bool may = near.distance < half / std::cos(M_PI / 8) + 2;
      if (must != covered && may != covered) {
        ++wrong;
        if (wrong == 1)
          MESSAGE(x << ' ' << y << " d " << near.distance << " half " << half << " beside "
                    << near.beside << " covered " << covered << " pts " << [&] {
                         std::string t;
                         for (auto p : road.points)
                           t += std::to_string(p.x) + ',' + std::to_string(p.y) + ' ';
                         return t;
                       }());
      }
      if (must || !may) ++looked;
    }
  }
  CHECK_EQ(wrong, 0);
  return looked;
}

Road road(std::vector<Point> points, bool closed) {
  return {RoadKind::kSolid, Length::from_mm(0.45), closed, std::move(points)};
}

}  // namespace

TEST_CASE("a straight road covers a rectangle, a bend is mitred, a turn is round outside") {
  const Region straight =
      core::uncovered(kPlate, {road({{0, 0}, {100'000, 0}}, false)}, Length::from_mm(2));
  CHECK_EQ(straight.area_mm2(), doctest::Approx(1600 - 20));
  // The square on the turn has its outer corner cut off by two tangents.
  const Region turned = core::uncovered(
      kPlate, {road({{0, 0}, {100'000, 0}, {100'000, 100'000}}, false)}, Length::from_mm(2));
  const double corner = std::tan(M_PI / 8) * 1;  // two kites of an octagon
  CHECK_EQ(turned.area_mm2(), doctest::Approx(1600 - 40 + 1 - 2 * corner + 0).epsilon(0.0001));
}

TEST_CASE("repeated points, single points and hairpins are taken") {
  CHECK_EQ(core::uncovered(kPlate, {road({{0, 0}, {0, 0}}, false)}, Length::from_mm(1)), kPlate);
  check_cover(road({{0, 0}, {50'000, 0}, {50'000, 0}, {0, 10}}, false), Length::from_mm(1));
  check_cover(road({{0, 0}, {50'000, 0}, {0, 0}}, false), Length::from_mm(1));
  check_cover(road({{0, 0}, {100, 0}, {0, 100}}, true), Length::from_mm(1));
}

TEST_CASE("what is covered is what is near, on random roads with long and short pieces") {
  constexpr std::uint64_t kSeed = 20261126;
  CAPTURE(kSeed);
  Random random(kSeed);
  int looked = 0;
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    std::vector<Point> points = {{0, 0}};
    double angle = random.between(0, 6.28);
    const double step = i % 3 == 0 ? 30'000 : 4'000, turn = i % 2 == 0 ? 3.1 : 0.4;
    for (int k = 0; k < 25; ++k) {
      const Point from = points.back();
      angle += random.between(-turn, turn);
      const double length = random.between(10, step);
      const Point to{static_cast<std::int32_t>(
                         std::clamp(from.x + length * std::cos(angle), -140'000.0, 140'000.0)),
                     static_cast<std::int32_t>(
                         std::clamp(from.y + length * std::sin(angle), -140'000.0, 140'000.0))};
      if (to != from) points.push_back(to);
    }
    looked += check_cover(road(points, i % 4 == 1), Length::from_mm(random.between(0.2, 2)));
  }
  CHECK_GE(looked, 100'000);
}
