// Perimeters in areas with other numbers of them: as many as are asked for on either side, and
// where the sides meet nothing is laid twice and nothing is left open.
#include "core/roads/area_perimeters.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/offset_contours.h"
#include "core/offsets/slice_offsets.h"
#include "core/regions/point_location.h"
#include "core/regions/polyline.h"
#include "core/regions/segment_grid.h"
#include "tests/support/random_regions.h"
#include "tests/support/road_checks.h"

using core::AreaPerimeters;
using core::ChangedAreas;
using core::Length;
using core::Perimeters;
using core::Point;
using core::Region;
using core::Road;
using core::RoadKind;
using core::Settings;

namespace {

constexpr Length kHeight = Length::from_units(2'000);

Point at_mm(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x * core::kUnitsPerMm)),
          static_cast<std::int32_t>(std::lround(y * core::kUnitsPerMm))};
}

Region box_mm(double x0, double y0, double x1, double y1) {
  return Region::from_clean_rings({{at_mm(x0, y0), at_mm(x1, y0), at_mm(x1, y1), at_mm(x0, y1)}});
}

core::IslandOffsets cut(const Region& region, const Settings& settings) {
  core::Slice slice;
  slice.index = 3;
  slice.height = kHeight;
  slice.region = region;
  const auto offsets = core::OffsetCutter(settings).cut(slice);
  core::IslandOffsets island{region, {}, offsets->wide_core, offsets->interior};
  for (const core::OffsetContours& line : offsets->perimeters) {
    island.perimeters.push_back(flatten(line, settings.arc_tolerance));
  }
  return island;
}

Settings with(int perimeters) {
  Settings settings;
  settings.perimeters = perimeters;
  return settings;
}

Perimeters plain(const Region& region, int perimeters) {
  return core::perimeters(cut(region, with(perimeters)), kHeight, with(perimeters));
}

core::ChangedArea area_of(int perimeters, Region region) {
  core::ChangedArea area;
  area.change.perimeters = perimeters;
  area.region = std::move(region);
  return area;
}

AreaPerimeters mixed(const Region& region, int perimeters, const ChangedAreas& areas) {
  core::Slice slice;
  slice.areas = std::make_shared<const ChangedAreas>(areas);
  const Settings settings = with(perimeters);
  return core::area_perimeters(cut(region, settings), core::perimeter_areas(slice, settings),
                               kHeight, settings);
}

// How many roads cross the way.
int crossings(const std::vector<Road>& roads, Point from, Point to) {
  int count = 0;
  for (const Road& road : roads) {
    const std::size_t n = road.points.size();
    for (std::size_t i = 0; i + (road.closed ? 0 : 1) < n; ++i) {
      const Point a = road.points[i], b = road.points[(i + 1) % n];
      const bool sides = (core::cross(a, b, from) > 0) != (core::cross(a, b, to) > 0);
      const bool ends = (core::cross(from, to, a) > 0) != (core::cross(from, to, b) > 0);
      if (sides && ends) ++count;
    }
  }
  return count;
}

// Shares of the region's points that are neither interior nor under a bead; and that are both, by
// more than a hair.
struct Misses {
  double open = 0, twice = 0;
};

Misses misses(const Region& region, const std::vector<Road>& roads, const Region& interior,
              test::Random& random) {
  constexpr double kHair_mm = 0.03;
  const core::PointLocation inside(region), deep(interior);
  const core::SegmentGrid edge(Length::from_mm(0.5), interior);
  std::vector<core::Segment> segments;
  for (const Road& road : roads) {
    const std::size_t n = road.points.size();
    for (std::size_t i = 0; i + (road.closed ? 0 : 1) < n; ++i) {
      segments.push_back({road.points[i], road.points[(i + 1) % n]});
    }
  }
  const core::SegmentGrid lines(Length::from_mm(0.5), segments);
  const double spacing_mm = core::perimeter_spacing(Settings(), kHeight).mm();
  const core::Box box = region.box();
  int points = 0, open = 0, twice = 0;
  while (points < 4'000) {
    const Point at{random.integer(box.min.x, box.max.x), random.integer(box.min.y, box.max.y)};
    if (!inside.contains(at)) continue;
    ++points;
    const bool in = deep.contains(at);
    const bool near_edge = edge.any_within(at, Length::from_mm(kHair_mm));
    if (near_edge) continue;
    if (!in && !lines.any_within(at, Length::from_mm(spacing_mm / 2 + kHair_mm))) ++open;
    if (in && lines.any_within(at, Length::from_mm(spacing_mm / 2 - kHair_mm))) ++twice;
  }
  return {1.0 * open / points, 1.0 * twice / points};
}

int open_ends(const std::vector<Road>& roads) {
  return 2 * static_cast<int>(std::count_if(roads.begin(), roads.end(),
                                            [](const Road& road) { return !road.closed; }));
}

bool same(const std::vector<Road>& a, const std::vector<Road>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Road& r, const Road& s) {
    return r.points == s.points && r.widths == s.widths && r.width == s.width &&
           r.closed == s.closed && r.kind == s.kind;
  });
}

}  // namespace

TEST_CASE("half a box: as many perimeters as asked for on either side, outer ones in one piece") {
  const Region box = box_mm(0, 0, 40, 20);
  for (const int other : {1, 3, 5}) {
    CAPTURE(other);
    const AreaPerimeters laid = mixed(box, 2, {area_of(other, box_mm(20, -5, 60, 30))});
    const std::vector<Road>& roads = laid.around.roads;
    CHECK_EQ(crossings(roads, at_mm(10, -1), at_mm(10, 10)), 2);
    CHECK_EQ(crossings(roads, at_mm(30, -1), at_mm(30, 10)), other);
    CHECK_EQ(crossings(roads, at_mm(41, 7), at_mm(25, 7)), other);
    CHECK_EQ(crossings(roads, at_mm(-1, 7), at_mm(15, 7)), 2);
    int closed = 0, outer = 0;
    for (const Road& road : roads) {
      closed += road.closed ? 1 : 0;
      outer += road.kind == RoadKind::kOuterPerimeter ? 1 : 0;
      // The others end at the border.
      if (road.closed) continue;
      for (const Point end : {road.points.front(), road.points.back()}) {
        CHECK_EQ(end.x, doctest::Approx(200'000).epsilon(1e-4));
      }
    }
    CHECK_EQ(outer, 1);
    CHECK_EQ(closed, std::min(2, other));
    CHECK_EQ(static_cast<int>(roads.size()), std::max(2, other));
    // One interior, without a seam at the border.
    CHECK_EQ(laid.around.interior.rings().size(), 1);
    const double s = core::perimeter_spacing(Settings(), kHeight).mm();
    const double left = plain(box, 2).interior.area_mm2(),
                 right = plain(box, other).interior.area_mm2();
    CHECK_EQ(laid.around.interior.area_mm2(), doctest::Approx((left + right) / 2).epsilon(1e-4));
    CHECK_EQ(test::laid_mm2(roads, kHeight),
             doctest::Approx((test::laid_mm2(plain(box, 2).roads, kHeight) +
                              test::laid_mm2(plain(box, other).roads, kHeight)) /
                             2)
                 .epsilon(1e-4));
    // Bridges reach as far as the innermost perimeter's centre line.
    CHECK_EQ(core::subtract(laid.around.interior, laid.innermost).area_mm2(),
             doctest::Approx(0).epsilon(1e-3));
    CHECK_EQ(laid.innermost.area_mm2() - laid.around.interior.area_mm2(),
             doctest::Approx(laid.innermost.perimeter_mm() * s / 2).epsilon(0.05));
  }
}

TEST_CASE("random islands, areas and numbers: nothing is laid twice, nothing is left open") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  test::Random random(seed);
  double laid_mm2 = 0, expected_mm2 = 0;
  int closed = 0, open = 0;
  for (int round = 0; round < 30; ++round) {
    CAPTURE(round);
    const core::Ring blob = test::random_blob(random, 40, 0, 0, random.between(8, 16), 0.2);
    Region region = core::clean({blob}, core::FillRule::kPositive);
    const double hole_x = random.between(-3, 3);
    region = core::subtract(region, box_mm(hole_x, -1.5, hole_x + 3, 1.5));
    ChangedAreas areas;
    for (int i = 0, count = random.integer(1, 3); i < count; ++i) {
      const double x = random.between(-16, 8), y = random.between(-16, 8);
      areas.push_back(area_of(random.integer(1, 6),
                              box_mm(x, y, x + random.between(1, 20), y + random.between(1, 20))));
    }
    const int number = random.integer(1, 4);
    const AreaPerimeters laid = mixed(region, number, areas);
    Misses worst;
    for (int n = 1; n <= 6; ++n) {
      const Perimeters alone = plain(region, n);
      const Misses these = misses(region, alone.roads, alone.interior, random);
      worst = {std::max(worst.open, these.open), std::max(worst.twice, these.twice)};
    }
    const Misses found = misses(region, laid.around.roads, laid.around.interior, random);
    CHECK_LE(found.open, worst.open + 0.004);
    // The measure takes ends for round: they reach over the border.
    const double round_mm2 = 3.1416 / 2 * std::pow(0.2, 2);
    const double ends = open_ends(laid.around.roads) * round_mm2 / region.area_mm2();
    CHECK_LE(found.twice, worst.twice + ends + 0.003);
    laid_mm2 += test::laid_mm2(laid.around.roads, kHeight) + laid.around.interior.area_mm2();
    expected_mm2 += region.area_mm2();
    for (const Road& road : laid.around.roads) {
      if (road.kind == RoadKind::kOuterPerimeter) ++(road.closed ? closed : open);
    }
  }
  // Around contours, but where a narrow place that is filled otherwise lies just at a border.
  CHECK_GT(closed, 40);
  CHECK_LE(open, 4);
  CHECK_EQ(laid_mm2, doctest::Approx(expected_mm2).epsilon(0.01));
}

TEST_CASE("an area that covers an island, and one that is elsewhere, or asks for the same") {
  test::Random random(7);
  const Region region =
      core::clean({test::random_blob(random, 30, 0, 0, 10, 0.3)}, core::FillRule::kPositive);
  const AreaPerimeters all = mixed(region, 2, {area_of(4, box_mm(-30, -30, 30, 30))});
  CHECK(same(all.around.roads, plain(region, 4).roads));
  CHECK(all.around.interior == plain(region, 4).interior);
  const AreaPerimeters none = mixed(region, 2, {area_of(4, box_mm(40, 40, 50, 50))});
  CHECK(same(none.around.roads, plain(region, 2).roads));
  core::Slice slice;
  slice.areas =
      std::make_shared<const ChangedAreas>(ChangedAreas{area_of(2, box_mm(-30, -30, 30, 30))});
  CHECK(core::perimeter_areas(slice, with(2)).empty());
}
