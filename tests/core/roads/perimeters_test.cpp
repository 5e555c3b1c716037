// Roads of narrow places: laws, and a raster as the second computation.
#include "core/roads/perimeters.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "core/booleans/boolean.h"
#include "core/offsets/slice_offsets.h"
#include "core/regions/polyline.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"
#include "tests/support/road_checks.h"

using core::Length;
using core::Perimeters;
using core::Point;
using core::Region;
using core::Ring;
using core::Road;
using core::Settings;
using test::Random;

namespace {

const Length kHeight = Length::from_mm(0.2);

Perimeters plan(const Region& region, const Settings& settings) {
  core::OffsetCutter cutter(settings);
  const core::Slice slice{0, Length(), kHeight, region, {}};
  const auto offsets = cutter.cut(slice);
  core::IslandOffsets island{region, {}, offsets->wide_core, offsets->interior};
  for (const auto& line : offsets->perimeters) {
    island.perimeters.push_back(core::flatten(line, settings.arc_tolerance));
  }
  return core::perimeters(std::move(island), kHeight, settings);
}

Perimeters plan(const Region& region, int perimeters = 2) {
  Settings settings;
  settings.perimeters = perimeters;
  return plan(region, settings);
}

Ring circle(double radius, int corners, bool hole) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back({static_cast<std::int32_t>(std::lround(radius * 10'000 * std::cos(angle))),
                    static_cast<std::int32_t>(std::lround(radius * 10'000 * std::sin(angle)))});
  }
  if (hole) std::reverse(ring.begin(), ring.end());
  return ring;
}

Region turned(const Region& region, double angle) {
  std::vector<Ring> rings = region.rings();
  for (Ring& ring : rings) {
    for (Point& p : ring) {
      const double x = p.x, y = p.y, c = std::cos(angle), s = std::sin(angle);
      p = {static_cast<std::int32_t>(std::lround(x * c - y * s)),
           static_cast<std::int32_t>(std::lround(x * s + y * c))};
    }
  }
  return core::clean(rings, core::FillRule::kNonZero);
}

// What should be laid: the region less the interior, less the round sides of beads along its edge.
double wanted_mm2(const Region& region, const Perimeters& plan) {
  const double h = kHeight.mm(), rim = h * (1 - std::numbers::pi / 4) / 2;
  return region.area_mm2() - plan.interior.area_mm2() - rim * region.perimeter_mm();
}

// Shares of the region's points that no bead covers, and that two beads cover for more than what
// neighbours overlap.
struct Cover {
  double open = 0;
  double twice = 0;
};

// Of a road between its points i and i + 1, where `p` is nearest.
double width_beside(const Road& road, std::size_t i, Point p) {
  const std::size_t j = (i + 1) % road.points.size();
  const Point a = road.points[i], b = road.points[j];
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double along = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
  const double from = static_cast<double>(core::width_at(road, i).units());
  const double to = static_cast<double>(core::width_at(road, j).units());
  return from + std::clamp(along, 0.0, 1.0) * (to - from);
}

Cover cover_of(const Region& region, const Perimeters& plan, double step_mm) {
  const core::Box box = region.box();
  const auto step = static_cast<std::int32_t>(step_mm * 10'000);
  // A bead's share of the room, a little less and a little more than it.
  const double rim = kHeight.mm() * (1 - std::numbers::pi / 4) * 10'000;
  int all = 0, open = 0, twice = 0;
  for (std::int32_t y = box.min.y + step / 2; y < box.max.y; y += step) {
    for (std::int32_t x = box.min.x + step / 2; x < box.max.x; x += step) {
      const Point p{x, y};
      if (!region.contains(p) || plan.interior.contains(p)) continue;
      ++all;
      int outer = 0, inner = 0;
      for (const Road& road : plan.roads) {
        const std::size_t count = road.points.size();
        bool near = false, well = false;
        for (std::size_t i = 0; i + (road.closed ? 0 : 1) < count; ++i) {
          const core::Segment piece{road.points[i], road.points[(i + 1) % count]};
          const double width = width_beside(road, i, p);
          const double away = test::distance_to_segment(p, piece);
          near = near || away <= width / 2 + 50;
          well = well || away <= (width - rim) / 2 - 50;
        }
        outer += near ? 1 : 0;
        inner += well ? 1 : 0;
      }
      open += outer == 0 ? 1 : 0;
      twice += inner > 1 ? 1 : 0;
    }
  }
  return {static_cast<double>(open) / all, static_cast<double>(twice) / all};
}

double ratio(const Region& region, const Perimeters& plan) {
  return test::laid_mm2(plan.roads, kHeight) / wanted_mm2(region, plan);
}

}  // namespace

TEST_CASE("strips of any width hold what is laid") {
  for (const int perimeters : {1, 2, 3}) {
    for (double width = 0.21; width < 3; width += 0.07) {
      const Region region = turned(test::rectangle_region(0, 0, 100, width), 0.3);
      const Perimeters planned = plan(region, perimeters);
      CAPTURE(perimeters);
      CAPTURE(width);
      CHECK_EQ(ratio(region, planned), doctest::Approx(1).epsilon(0.01));
      CHECK_LT(test::sticks_out_mm(region, planned.roads), 0.003);
    }
  }
}

TEST_CASE("rings of any width hold what is laid, by closed roads alone") {
  for (double width = 0.21; width < 3; width += 0.13) {
    const Region region =
        Region::from_clean_rings({circle(20, 128, false), circle(20 - width, 128, true)});
    const Perimeters planned = plan(region);
    CAPTURE(width);
    CHECK_EQ(ratio(region, planned), doctest::Approx(1).epsilon(0.01));
    CHECK_LT(test::sticks_out_mm(region, planned.roads), 0.005);
    for (const Road& road : planned.roads) CHECK(road.closed);
  }
}

TEST_CASE("discs of any size are filled") {
  for (const int corners : {24, 48, 96}) {
    for (double radius = 0.35; radius < 1.6; radius += 0.05) {
      CAPTURE(corners);
      CAPTURE(radius);
      const Region region = Region::from_clean_rings({circle(radius, corners, false)});
      const Perimeters planned = plan(region);
      CHECK_LT(cover_of(region, planned, 0.02).open, 0.15);
      // Larger ones have room for an interior, which the fill sees to.
      const bool pin = radius < 1;
      CHECK_LT(ratio(region, planned), pin ? 1.02 : 1.25);
      if (pin) CHECK_GT(ratio(region, planned), 0.98);
      CHECK_LT(test::sticks_out_mm(region, planned.roads), 0.003);
    }
  }
}

TEST_CASE("places that narrow, meet and end are filled once") {
  const char* shapes[] = {
      "0:0 30:0 30:3",                                            // a wedge
      "0:0 10:0.2 20:0 20:1.5 10:1.3 0:1.5",                      // a neck
      "0:0 30:0 30:0.6 15.3:0.6 15.3:15 14.7:15 14.7:0.6 0:0.6",  // a tee
      "0:0 10:0 10:1.1 5.5:1.1 5.5:6 4.4:6 4.4:1.1 0:1.1",        // a wider one
      "4:0 5:0 5:4 9:4 9:5 5:5 5:9 4:9 4:5 0:5 0:4 4:4",          // a cross
      "0:0 10:0 10:4.8 20:4.8 20:5.2 10:5.2 10:10 0:10",          // a rib on a body
      "0:0 10:0 10:9 15:14 14.5:14.5 9.5:10 0:10",                // one at 45°
      "0:0 8:1 10:-6 11:1.2 19:2 11.6:3 9:10 7.6:3",              // a star
      "0:0 6:0 6:0.9 0.9:0.9 0.9:6 0:6",                          // a corner
  };
  for (const char* shape : shapes) {
    for (const int perimeters : {1, 2, 3}) {
      const Region region = test::region_from_text(shape);
      const Perimeters planned = plan(region, perimeters);
      const Cover cover = cover_of(region, planned, 0.05);
      MESSAGE(std::string(shape) << " p" << perimeters << ": laid " << ratio(region, planned)
                                 << ", open " << cover.open << ", twice " << cover.twice);
      CHECK_EQ(ratio(region, planned), doctest::Approx(1).epsilon(0.03));
      CHECK_LT(cover.open, 0.015);
      CHECK_LT(cover.twice, 0.03);
      CHECK_LT(test::sticks_out_mm(region, planned.roads), 0.01);
    }
  }
}

TEST_CASE("a rib is joined to its body without a gap") {
  for (double width = 0.25; width < 1.45; width += 0.05) {
    CAPTURE(width);
    const double low = 5 - width / 2, high = 5 + width / 2;
    const auto at = [](double mm) { return static_cast<std::int32_t>(std::lround(mm * 10'000)); };
    for (const double angle : {0.0, 0.7854}) {
      const Region region = turned(Region::from_clean_rings({{{0, 0},
                                                              {at(10), 0},
                                                              {at(10), at(low)},
                                                              {at(20), at(low)},
                                                              {at(20), at(high)},
                                                              {at(10), at(high)},
                                                              {at(10), at(10)},
                                                              {0, at(10)}}}),
                                   angle);
      const Perimeters planned = plan(region);
      for (double x = 9; x < 20 - width / 2; x += 0.02) {
        const double px = x * std::cos(angle) - 5 * std::sin(angle);
        const double py = x * std::sin(angle) + 5 * std::cos(angle);
        const Point p{at(px), at(py)};
        if (planned.interior.contains(p)) continue;
        bool covered = false;
        for (const Road& road : planned.roads) {
          const std::size_t count = road.points.size();
          for (std::size_t i = 0; i + (road.closed ? 0 : 1) < count && !covered; ++i) {
            const core::Segment piece{road.points[i], road.points[(i + 1) % count]};
            covered = test::distance_to_segment(p, piece) <=
                      static_cast<double>(core::width_at(road, i).units()) / 2 + 100;
          }
        }
        CAPTURE(x);
        CHECK(covered);
      }
    }
  }
}

// Rounding may decide otherwise where a count holds for just as long as it has to.
TEST_CASE("a region moved and a region mirrored have the same roads") {
  Random random(1302);
  for (int round = 0; round < 60; ++round) {
    const Region region = core::clean(
        {test::random_blob(random, random.integer(5, 30), 5, 5, 4, 0.9)}, core::FillRule::kNonZero);
    if (core::islands(region).size() != 1) continue;
    CAPTURE(round);
    std::vector<Ring> moved = region.rings(), mirrored = region.rings();
    for (Ring& ring : moved) {
      for (Point& p : ring) p = {p.x + 1'234'567, p.y - 7'654'321};
    }
    for (Ring& ring : mirrored) {
      for (Point& p : ring) p.x = -p.x;
      std::reverse(ring.begin(), ring.end());
    }
    const Perimeters once = plan(region);
    for (auto& rings : {moved, mirrored}) {
      const Perimeters again = plan(Region::from_clean_rings(rings));
      CHECK_EQ(test::laid_mm2(again.roads, kHeight),
               doctest::Approx(test::laid_mm2(once.roads, kHeight)).epsilon(0.03));
      CHECK_EQ(again.interior.area_mm2(), doctest::Approx(once.interior.area_mm2()).epsilon(0.03));
    }
  }
}

TEST_CASE("crumbs of less than a micrometre have no roads") {
  for (const Ring& ring : {Ring{{79, -26437}, {84, -26433}, {79, -26436}},
                           Ring{{7686, 9863}, {7693, 9856}, {7695, 9862}}}) {
    for (int perimeters = 1; perimeters <= 4; ++perimeters) {
      const Perimeters planned = plan(Region::from_clean_rings({ring}), perimeters);
      CHECK(planned.roads.empty());
      CHECK(planned.interior.empty());
    }
  }
}

TEST_CASE("random narrow regions: closed roads within the region, filled") {
  const std::uint64_t seed = std::random_device{}();
  CAPTURE(seed);
  Random random(seed);
  double laid = 0, wanted = 0;
  int open = 0;
  for (int round = 0; round < 1'500; ++round) {
    // One after the other: compilers order arguments as they like.
    const double size = random.between(2, 12);
    const Region all = test::random_region(random, random.integer(10, 60), size);
    for (core::Island& island : core::islands(all)) {
      const Region region = core::region_of(std::move(island));
      const Perimeters planned = plan(region, random.integer(1, 4));
      CAPTURE(round);
      CHECK(test::is_clean(planned.interior));
      CHECK_LT(test::sticks_out_mm(region, planned.roads), 0.03);
      for (const Road& road : planned.roads) {
        CHECK_GE(road.points.size(), road.closed ? 3u : 2u);
        CHECK((road.widths.empty() || road.widths.size() == road.points.size()));
        open += !road.closed && road.kind != core::RoadKind::kGapFill ? 1 : 0;
      }
      laid += test::laid_mm2(planned.roads, kHeight);
      wanted += wanted_mm2(region, planned);
    }
  }
  MESSAGE("laid " << laid << " of " << wanted << " mm², " << open << " lines left open");
  CHECK_EQ(open, 0);
  CHECK_EQ(laid / wanted, doctest::Approx(1).epsilon(0.06));
}
