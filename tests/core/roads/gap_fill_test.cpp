#include "core/roads/gap_fill.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/booleans/boolean.h"
#include "core/regions/polyline.h"
#include "core/roads/bead_cover.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Length;
using core::Point;
using core::Region;
using core::Road;
using core::Settings;
using test::Random;

namespace {

const Length kHeight = Length::from_mm(0.2);

// What lies between two arcs about one centre, as thick as `thick` in the middle and nothing at its
// ends: what a ring leaves of a wall that widens and narrows again.
Region crescent(double radius_mm, double thick_mm, double half_angle, int points) {
  core::Ring ring;
  const auto add = [&](double angle, double radius) {
    ring.push_back({static_cast<std::int32_t>(std::lround(radius * 10'000 * std::cos(angle))),
                    static_cast<std::int32_t>(std::lround(radius * 10'000 * std::sin(angle)))});
  };
  for (int i = -points; i < points; ++i) {
    const double share = static_cast<double>(i) / points;
    add(share * half_angle, radius_mm + thick_mm * (1 - share * share));
  }
  for (int i = points; i > -points; --i) {
    add(static_cast<double>(i) / points * half_angle, radius_mm);
  }
  return core::clean({ring}, core::FillRule::kNonZero);
}

// How far the worst of the roads' centre lines leaves the region, in units.
double farthest_outside(const Region& region, const std::vector<Road>& roads) {
  double worst = 0;
  for (const Road& road : roads) {
    for (std::size_t i = 0; i + (road.closed ? 0 : 1) < road.points.size(); ++i) {
      const Point a = road.points[i], b = road.points[(i + 1) % road.points.size()];
      for (int part = 0; part <= 10; ++part) {
        const Point p = core::between(a, b, part / 10.0);
        worst = std::max(worst, -test::signed_distance(region, p.x, p.y));
      }
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("a strip gets one road that holds what the strip holds") {
  const Region strip = test::region_from_text("0:0 10:0 10:0.3 0:0.3");
  const std::vector<Road> roads = core::gap_fill_roads(strip, core::kBeadSeam, kHeight, Settings());
  REQUIRE_EQ(roads.size(), 1u);
  // Its round sides reach into what the roads beside it leave.
  const double side = kHeight.mm() * (1 - std::numbers::pi / 4) + core::kBeadSeam.mm();
  CHECK_EQ(roads[0].width.mm(), doctest::Approx(0.3 + side).epsilon(0.001));
  const std::vector<Road> whole = core::gap_fill_roads(strip, Length(), kHeight, Settings());
  REQUIRE_EQ(whole.size(), 1u);
  CHECK_EQ((roads[0].width - whole[0].width).units(),
           doctest::Approx(core::kBeadSeam.units()).epsilon(0.01));
  CHECK_GT(core::length_mm(roads[0]), 9.6);
}

TEST_CASE("a square too short for an axis gets a blot, a crumb nothing") {
  const auto roads = [](const char* text) {
    return core::gap_fill_roads(test::region_from_text(text), core::kBeadSeam, kHeight, Settings());
  };
  CHECK_EQ(roads("0:0 0.45:0 0.45:0.4 0:0.4").size(), 1u);
  CHECK(roads("0:0 0.1:0 0.1:0.1 0:0.1").empty());
}

TEST_CASE("no road leads out of a crescent along its chord") {
  int roads_seen = 0;
  for (const double thick : {0.04, 0.0503, 0.0506, 0.051, 0.06, 0.1, 0.15, 0.3}) {
    for (const double half_angle : {0.1, 0.3, 0.6, 1.2}) {
      CAPTURE(thick);
      CAPTURE(half_angle);
      const Region region = crescent(9, thick, half_angle, 8);
      const std::vector<Road> roads =
          core::gap_fill_roads(region, core::kBeadSeam, kHeight, Settings());
      roads_seen += static_cast<int>(roads.size());
      CHECK_LE(farthest_outside(region, roads), 100);
    }
  }
  CHECK_GE(roads_seen, 10);
}

TEST_CASE("random gaps: roads stay within them") {
  constexpr std::uint64_t kSeed = 20261126;
  CAPTURE(kSeed);
  Random random(kSeed);
  std::size_t roads_seen = 0;
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    const Region region = test::random_region(random, 60, 4);
    const std::vector<Road> roads =
        core::gap_fill_roads(region, core::kBeadSeam, kHeight, Settings());
    roads_seen += roads.size();
    // Pieces are simplified by 10 µm before.
    CHECK_LE(farthest_outside(region, roads), 110);
  }
  CHECK_GE(roads_seen, 100u);
}
