#include "core/roads/wall_fill.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/regions/polyline.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"
#include "tests/support/road_checks.h"

using namespace core;

namespace {

constexpr double kHeightMm = 0.2;
const Length kHeight = Length::from_mm(kHeightMm);

// What is laid in a square about a place, against what it holds: by samples along the roads.
double filled_share(const std::vector<Road>& roads, Point about, double half_mm) {
  const double half = half_mm * kUnitsPerMm;
  double sum_mm2 = 0;
  for (const Road& road : roads) {
    for (std::size_t i = 1; i < road.points.size(); ++i) {
      const Point a = road.points[i - 1], b = road.points[i];
      const double mm = distance_mm(a, b);
      const int parts = 1 + static_cast<int>(mm / 0.01);
      for (int part = 0; part < parts; ++part) {
        const Point p = between(a, b, (part + 0.5) / parts);
        if (std::abs(p.x - about.x) > half || std::abs(p.y - about.y) > half) continue;
        sum_mm2 += mm / parts * bead_area_mm2(road.width, kHeight) / kHeightMm;
      }
    }
  }
  return sum_mm2 / (4 * half_mm * half_mm);
}

// Whether a bead lies there.
bool covered(const std::vector<Road>& roads, Point p) {
  for (const Road& road : roads) {
    const double half = static_cast<double>(road.width.units()) / 2;
    const std::size_t count = road.points.size();
    for (std::size_t i = 0; i < (road.closed ? count : count - 1); ++i) {
      const double from = static_cast<double>(width_at(road, i).units()) / 2;
      const double to = static_cast<double>(width_at(road, (i + 1) % count).units()) / 2;
      const Segment line{road.points[i], road.points[(i + 1) % count]};
      if (distance_units(p, line) <= std::max(half, std::min(from, to))) return true;
    }
  }
  return false;
}

Region disc(double radius_mm) {
  Ring ring;
  for (int i = 0; i < 200; ++i) {
    const double angle = 2 * M_PI * i / 200, r = radius_mm * kUnitsPerMm;
    ring.push_back({static_cast<std::int32_t>(std::lround(r * std::cos(angle))),
                    static_cast<std::int32_t>(std::lround(r * std::sin(angle)))});
  }
  return clean({ring}, FillRule::kNonZero);
}

// The share of a ring's places that no bead covers.
double bare_share(const std::vector<Road>& roads, double inner_mm, double outer_mm) {
  constexpr int kPlaces = 4'000;
  int bare = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const double angle = 2.39996 * i;  // the golden angle: evenly over the ring
    const double share = (i + 0.5) / kPlaces;
    const double r = std::sqrt(std::lerp(inner_mm * inner_mm, outer_mm * outer_mm, share)) * 1e4;
    const Point at{static_cast<std::int32_t>(r * std::cos(angle)),
                   static_cast<std::int32_t>(r * std::sin(angle))};
    bare += covered(roads, at) ? 0 : 1;
  }
  return static_cast<double>(bare) / kPlaces;
}

}  // namespace

TEST_CASE("a rim is as dense as if there were nothing behind it") {
  const Region whole = disc(20);
  for (const double thick : {0.42, 1.0, 1.5}) {
    CAPTURE(thick);
    const Region rim = subtract(whole, disc(20 - thick));
    const auto with = wall_roads(whole, rim, 2, kHeight, Settings());
    const auto alone = wall_roads(rim, {}, 2, kHeight, Settings());
    const double outer = 20 - thick / 2;
    CHECK_LE(bare_share(with, outer, 20), bare_share(alone, outer, 20));
    CHECK_LE(bare_share(with, outer, 20), 0.0005);
    CHECK_LE(bare_share(with, 0, 20), 0.01);
    CHECK(test::laid_mm2(with, kHeight) / whole.area_mm2() == doctest::Approx(1).epsilon(0.015));
  }
  CHECK_GE(bare_share(wall_roads(whole, {}, 2, kHeight, Settings()), 19.5, 20), 0.005);
}

TEST_CASE("wide areas are as full in the middle as on the whole") {
  for (const double size : {18.0, 30.0, 60.0}) {
    CAPTURE(size);
    const auto units = static_cast<std::int32_t>(size * 10'000);
    const Region square =
        Region::from_clean_rings({{{0, 0}, {units, 0}, {units, units}, {0, units}}});
    const std::vector<Road> roads = wall_roads(square, {}, 2, kHeight, Settings());
    CHECK(test::laid_mm2(roads, kHeight) / square.area_mm2() == doctest::Approx(1).epsilon(0.01));
    CHECK(filled_share(roads, {units / 2, units / 2}, size / 4) ==
          doctest::Approx(1).epsilon(0.01));
  }
}

TEST_CASE("tops: width, flow and patterns of their own; what is laid is what they hold") {
  const Region square = test::region_from_text("0:0 30:0 30:20 0:20");
  for (const SolidPattern pattern :
       {SolidPattern::kRectilinear, SolidPattern::kMonotonic, SolidPattern::kConcentric}) {
    for (const double width : {0.0, 0.4, 0.6}) {
      CAPTURE(width);
      Settings settings;
      settings.top_pattern = pattern;
      settings.top_width = Length::from_mm(width);
      const auto top = surface_roads(square, RoadKind::kTopSolid, 2, kHeight, settings);
      const double laid_mm2 = test::laid_mm2(top, kHeight);
      CHECK(laid_mm2 / square.area_mm2() == doctest::Approx(1).epsilon(0.01));
      for (const Road& road : top) {
        if (road.kind == RoadKind::kGapFill) continue;
        CHECK_EQ(road.kind, RoadKind::kTopSolid);
        CHECK(road.width.mm() == doctest::Approx(width > 0 ? width : 0.45).epsilon(0.1));
      }
      settings.top_flow = 0.9;
      const auto thin = surface_roads(square, RoadKind::kTopSolid, 2, kHeight, settings);
      CHECK(test::laid_mm2(thin, kHeight) / laid_mm2 == doctest::Approx(0.9).epsilon(0.002));
      // Bottoms have the pattern alone.
      const auto bottom = surface_roads(square, RoadKind::kBottomSolid, 2, kHeight, settings);
      CHECK(bottom.front().width.mm() == doctest::Approx(0.45).epsilon(0.1));
    }
  }
}

TEST_CASE("ironing lays its share of a dense layer, within the top") {
  const Region square = test::region_from_text("0:0 30:0 30:20 0:20");
  Settings settings;
  for (const double flow : {0.1, 0.15, 0.5}) {
    settings.ironing_flow = flow;
    const auto roads = ironing_roads(square, 2, kHeight, settings);
    REQUIRE_FALSE(roads.empty());
    // Up to half a nozzle from the edge.
    CHECK(test::laid_mm2(roads, kHeight) / (29.6 * 19.6) == doctest::Approx(flow).epsilon(0.02));
    CHECK_GE(test::least_depth_mm(square, roads), 0.199);
  }
  CHECK(ironing_roads({}, 2, kHeight, settings).empty());
}
