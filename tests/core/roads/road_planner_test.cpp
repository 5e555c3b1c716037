#include "core/roads/road_planner.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/slice_offsets.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/regions/polyline.h"
#include "core/regions/segment_grid.h"
#include "core/roads/road_order.h"
#include "core/roads/wall_fill.h"
#include "core/slices/plane_sweep.h"
#include "core/walls/wall_splitter.h"
#include "tests/support/mesh.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"
#include "tests/support/road_checks.h"
#include "tools/parts/part_maker.h"

using namespace core;

namespace {

constexpr double kHairMm = 0.03;

SplitLayer split(const Region& slice, const Region& loose, const Settings& settings,
                 LayerIndex index = 4) {
  SplitLayer layer;
  layer.slice.index = index;
  layer.slice.height = settings.layer_height;
  layer.slice.bottom = settings.layer_height * index;
  layer.slice.region = slice;
  OffsetCutter cutter(settings);
  layer.offsets = cutter.cut(layer.slice);
  if (slice.empty()) return layer;
  const std::vector<core::InnerOffset>& inners = layer.offsets->wall_inners;
  layer.loose = inners.empty() ? Region() : intersect(loose, inners.front().region);
  layer.solid = subtract(slice, layer.loose);
  return layer;
}

std::vector<Road> planned(const Settings& settings, const SplitLayer& layer) {
  return printing_order(RoadPlanner(settings).plan(layer));
}

std::vector<Road> of_kind(const std::vector<Road>& roads, RoadKind kind) {
  std::vector<Road> found;
  for (const Road& road : roads) {
    if (road.kind == kind) found.push_back(road);
  }
  return found;
}

void check_sound(const std::vector<Road>& roads) {
  for (const Road& road : roads) {
    CHECK_GE(road.points.size(), road.closed ? 3 : 2);
    CHECK_GT(road.width, Length());
    for (std::size_t i = 1; i < road.points.size(); ++i) {
      CHECK_NE(road.points[i - 1], road.points[i]);
    }
  }
}

}  // namespace

TEST_CASE("a solid square is dense, and no more is laid than it holds") {
  const Settings settings;
  const Region square = test::region_from_text("0:0 30:0 30:20 0:20");
  for (const double overlap : {1.0, 0.0}) {
    CAPTURE(overlap);
    Settings touching = settings;
    touching.road_overlap = overlap;
    const auto roads = planned(touching, split(square, {}, touching));
    check_sound(roads);
    test::Random random(1);
    CHECK_GE(test::covered_share(square, roads, 3'000, random), 0.993);
    CHECK_LE(test::sticks_out_mm(square, roads), kHairMm);
    const double laid = test::laid_mm2(roads, settings.layer_height) / square.area_mm2();
    CHECK_GT(laid, overlap == 1 ? 0.985 : 0.88);
    CHECK_LT(laid, 1.015);
  }
}

TEST_CASE("perimeters lie at their depths, the outer one printed last") {
  const Settings settings;
  const Region square = test::region_from_text("0:0 30:0 30:20 0:20");
  const auto roads = planned(settings, split(square, square, settings));
  const auto outer = of_kind(roads, RoadKind::kOuterPerimeter);
  const auto inner = of_kind(roads, RoadKind::kPerimeter);
  REQUIRE_EQ(outer.size(), 1);
  REQUIRE_EQ(inner.size(), 1);
  const double w = settings.road_width.mm();
  CHECK(test::least_depth_mm(square, outer) == doctest::Approx(w / 2).epsilon(1e-3));
  CHECK(test::least_depth_mm(square, inner) ==
        doctest::Approx(w / 2 + perimeter_spacing(settings, settings.layer_height).mm())
            .epsilon(1e-3));
  CHECK(outer[0].closed);
  CHECK_EQ(roads[0].kind, RoadKind::kPerimeter);
  CHECK_EQ(roads[1].kind, RoadKind::kOuterPerimeter);
}

TEST_CASE("loose roads lay their share of the inside, joins and ends counted") {
  for (const double density : {0.1, 0.2, 0.5}) {
    CAPTURE(density);
    Settings settings;
    settings.loose_density = density;
    const Region square = test::region_from_text("0:0 60:0 60:60 0:60");
    const Region inside = test::region_from_text("10:10 50:10 50:50 10:50");
    const SplitLayer layer = split(square, inside, settings);
    const auto loose = of_kind(planned(settings, layer), RoadKind::kLoose);
    REQUIRE_FALSE(loose.empty());
    const double share = test::laid_mm2(loose, settings.layer_height) / inside.area_mm2();
    CHECK(share == doctest::Approx(density).epsilon(0.001));
  }
}

TEST_CASE("fins narrower than two roads get one road of their own width") {
  const Settings settings;
  for (const double breadth : {0.22, 0.3, 0.4, 0.45, 0.55, 0.65}) {
    CAPTURE(breadth);
    const auto b = static_cast<std::int32_t>(breadth * 10'000);
    const Region fin = Region::from_clean_rings({{{0, 0}, {200'000, 0}, {200'000, b}, {0, b}}});
    const auto roads = planned(settings, split(fin, {}, settings));
    check_sound(roads);
    REQUIRE_FALSE(roads.empty());
    CHECK_LE(test::sticks_out_mm(test::region_from_text("-1:0 21:0 21:0.66 -1:0.66"), roads) -
                 (0.66 - breadth),
             kHairMm);
    test::Random random(3);
    CHECK_GE(test::covered_share(fin, roads, 1'000, random), 0.97);
    const double laid = test::laid_mm2(roads, settings.layer_height) / fin.area_mm2();
    CHECK_GT(laid, 0.75);
    CHECK_LT(laid, 1.1);
  }
}

TEST_CASE("where nothing fits there are no roads") {
  const Settings settings;
  const Region hair = test::region_from_text("0:0 20:0 20:0.1 0:0.1");
  CHECK(planned(settings, split(hair, {}, settings)).empty());
  CHECK(planned(settings, split({}, {}, settings)).empty());
}

TEST_CASE("bands of any breadth are dense") {
  const Settings settings;
  for (int i = 0; i < 24; ++i) {
    const double breadth = 0.1 + 0.09 * i;
    CAPTURE(breadth);
    const auto b = static_cast<std::int32_t>(breadth * 10'000);
    const Region band = Region::from_clean_rings({{{0, 0}, {200'000, 0}, {200'000, b}, {0, b}}});
    const auto roads = wall_roads(band, {}, 2, settings.layer_height, settings);
    check_sound(roads);
    test::Random random(5);
    CHECK_GE(test::covered_share(band, roads, 1'500, random), 0.98);
    const double laid = test::laid_mm2(roads, settings.layer_height) / band.area_mm2();
    CHECK_GT(laid, 0.9);
    CHECK_LT(laid, breadth < 0.2 ? 2.1 : 1.13);
  }
}

TEST_CASE("random walls are dense, inside, and hold what is laid") {
  Settings settings;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region slice = test::random_region(random, 60, 30);
    const Region loose =
        offset(slice, Length::from_mm(random.between(0.8, 3)), settings.arc_tolerance);
    const SplitLayer layer = split(slice, loose, settings);
    const auto roads = planned(settings, layer);
    check_sound(roads);
    CHECK_LE(test::sticks_out_mm(slice, roads), kHairMm);
    CHECK_GE(test::covered_share(layer.solid, roads, 3'000, random), 0.97);
    const double holds = layer.solid.area_mm2() + settings.loose_density * layer.loose.area_mm2();
    const double laid = test::laid_mm2(roads, settings.layer_height) / holds;
    CHECK_GT(laid, 0.93);
    CHECK_LT(laid, 1.07);
    const auto again = planned(settings, layer);
    REQUIRE_EQ(roads.size(), again.size());
    for (std::size_t i = 0; i < roads.size(); ++i) CHECK_EQ(roads[i].points, again[i].points);
  }
}

TEST_CASE("the first layer, and no other, has a skirt, outside the part by its distance") {
  Settings settings;
  settings.skirt_loops = 2;
  const Region square = test::region_from_text("0:0 10:0 10:10 0:10, 12:0 20:0 20:10 12:10");
  const auto first = planned(settings, split(square, {}, settings, 0));
  const auto skirt = of_kind(first, RoadKind::kSkirt);
  REQUIRE_EQ(skirt.size(), 2);
  CHECK_EQ(first[0].kind, RoadKind::kSkirt);
  const double w = settings.road_width.mm();
  CHECK(-test::least_depth_mm(square, {skirt[1]}) ==
        doctest::Approx(settings.skirt_distance.mm() + w / 2).epsilon(2e-2));
  CHECK(of_kind(planned(settings, split(square, {}, settings, 1)), RoadKind::kSkirt).empty());
}

TEST_CASE("the wall is dense up to its inner edge, however little of it the perimeters leave") {
  const Settings settings;
  const Region square = test::region_from_text("0:0 30:0 30:20 0:20");
  for (const double depth : {0.87, 0.88, 0.9, 0.95, 1.0, 1.2, 1.7, 2.3}) {
    CAPTURE(depth);
    const Region loose = core::offset(square, Length::from_mm(depth), settings.arc_tolerance);
    SplitLayer layer = split(square, square, settings);
    layer.loose = loose;
    layer.solid = subtract(square, loose);
    std::vector<Road> dense;
    for (const Road& road : planned(settings, layer)) {
      if (road.kind != RoadKind::kLoose) dense.push_back(road);
    }
    test::Random random(11);
    CHECK_GE(test::covered_share(layer.solid, dense, 4'000, random), 0.995);
  }
}

TEST_CASE("dense roads run in the wall, nowhere in the inside: a screw's layers") {
  Settings settings;
  settings.wall_thickness = Length::from_mm(1);
  OffsetCutter cutter(settings);
  WallSplitter splitter(settings);
  // Rows and rings end where the wall does, gap fill reaches into what those leave.
  const double beyond_max_mm = settings.road_width.mm() / 2;
  std::size_t looked_at = 0;
  const auto look = [&](const SplitLayer& layer) {
    const SegmentGrid edge(Length::from_mm(1), layer.loose);
    for (const Road& road : planned(settings, layer)) {
      if (road.kind == RoadKind::kLoose || road.kind == RoadKind::kSkirt) continue;
      for (std::size_t i = 1; i < road.points.size(); ++i) {
        for (int part = 0; part <= 4; ++part) {
          const Point p = between(road.points[i - 1], road.points[i], part / 4.0);
          ++looked_at;
          if (!layer.loose.contains(p)) continue;
          CAPTURE(layer.slice.index);
          CHECK(edge.any_within(p, Length::from_mm(beyond_max_mm)));
        }
      }
    }
  };
  PlaneSweep::Options options = test::exact_options();
  options.simplify_tolerance = settings.simplify_tolerance;
  const parts::Part screw = parts::screw();
  for (Slice& slice : test::sweep(test::triangles_of(screw), options).slices) {
    auto offsets = cutter.cut(slice);
    std::optional<SplitLayer> settled = splitter.push({std::move(slice), std::move(offsets)});
    for (; settled; settled = splitter.next()) look(*settled);
  }
  while (const std::optional<SplitLayer> settled = splitter.finish()) look(*settled);
  CHECK_GE(looked_at, 10'000u);
}

TEST_CASE(
    "where a roof is closed over a hollow, rows reach out over it, and no road runs along it") {
  Settings settings;
  settings.loose_pattern = LoosePattern::kLightning;
  const Region square = test::region_from_text("0:0 30:0 30:30 0:30");
  const auto left = [](double to_mm) { return test::rectangle_region(2, 2, to_mm - 2, 26); };
  SplitLayer layer = split(square, left(11), settings);
  layer.below = layer.above = std::make_shared<const Region>(square);
  layer.below_loose = std::make_shared<const Region>(left(11.4));
  // Before the right side was made solid, a wall of 1.2 mm parted two hollows.
  const Region right = test::rectangle_region(12.2, 2, 15.8, 26);
  layer.window_loose = std::make_shared<const Region>(unite(left(11), right));
  const Region hangs = test::rectangle_region(11, 3, 0.4, 24);
  double longest_mm = 0, laid_mm = 0;
  for (const Road& road : planned(settings, layer)) {
    const std::size_t count = road.points.size();
    for (std::size_t i = 0; i < (road.closed ? count : count - 1); ++i) {
      const Point a = road.points[i], b = road.points[(i + 1) % count];
      if (!hangs.contains({(a.x + b.x) / 2, (a.y + b.y) / 2})) continue;
      longest_mm = std::max(longest_mm, distance_mm(a, b));
      laid_mm += distance_mm(a, b);
    }
  }
  CHECK_GE(laid_mm, 5);
  CHECK_LE(longest_mm, 2);
}
