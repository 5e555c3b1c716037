#include "core/supports/support_roads.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <numbers>

#include "core/booleans/boolean.h"
#include "core/offsets/slice_offsets.h"
#include "core/offsets/voronoi_mountain.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;
using test::rectangle_region;

namespace {

SupportLayer layer_of(Region region, Region interface, LayerIndex index = 7) {
  return {index, std::make_shared<const Region>(std::move(region)),
          std::make_shared<const Region>(std::move(interface))};
}

double volume_mm3(const std::vector<Road>& roads, Length height, RoadKind kind) {
  double sum = 0;
  for (const Road& road : roads) sum += road.kind == kind ? core::volume_mm3(road, height) : 0;
  return sum;
}

const Length kHeight = Length::from_mm(0.2);

}  // namespace

TEST_CASE("the dense part is as full as its spacing says, the rest is a sheath with rows") {
  const Settings settings;
  const Region whole = rectangle_region(0, 0, 40, 30);
  const double spacing = perimeter_spacing(settings, kHeight).mm();
  for (const bool dense : {false, true}) {
    CAPTURE(dense);
    const auto roads = support_roads(layer_of(whole, dense ? whole : Region()), kHeight, settings);
    const RoadKind kind = dense ? RoadKind::kSupportInterface : RoadKind::kSupport;
    CHECK(std::all_of(roads.begin(), roads.end(), [&](const Road& r) { return r.kind == kind; }));
    // A bead fills its spacing; of the rest, rows cover their share.
    const double gap = dense ? 0.2 : 2.5;
    // Rows are the longest straight stretches but for the sheath's: at 45°, or across.
    double longest = 0, rise = 0;
    for (const Road& road : roads) {
      for (std::size_t i = 1; !road.closed && i < road.points.size(); ++i) {
        const double dx = road.points[i].x - road.points[i - 1].x;
        const double dy = road.points[i].y - road.points[i - 1].y;
        if (std::hypot(dx, dy) < longest) continue;
        longest = std::hypot(dx, dy);
        rise = dy / dx;
      }
    }
    CHECK_EQ(rise, doctest::Approx(dense ? -1 : 1).epsilon(0.01));
    const double inner = (40 - 2 * spacing) * (30 - 2 * spacing);
    const double asked = 0.2 * (1200 - inner + inner * spacing / (spacing + gap));
    CHECK_EQ(volume_mm3(roads, kHeight, kind), doctest::Approx(asked).epsilon(0.06));
  }
}

TEST_CASE("each part has its kind, and its flow") {
  Settings settings;
  settings.support_flow = 0.9;
  settings.support_interface_flow = 1.1;
  const Region whole = rectangle_region(0, 0, 40, 30), left = rectangle_region(-1, -1, 21, 32);
  const auto roads = support_roads(layer_of(whole, intersect(whole, left)), kHeight, settings);
  Settings plain;
  const auto same = support_roads(layer_of(whole, intersect(whole, left)), kHeight, plain);
  for (const RoadKind kind : {RoadKind::kSupport, RoadKind::kSupportInterface}) {
    const double flow = kind == RoadKind::kSupport ? 0.9 : 1.1;
    CHECK_EQ(volume_mm3(roads, kHeight, kind),
             doctest::Approx(flow * volume_mm3(same, kHeight, kind)).epsilon(0.001));
  }
  for (const Road& road : roads) {
    for (std::size_t i = 1; i < road.points.size(); ++i) {
      const double x = (road.points[i - 1].x + road.points[i].x) / 2e4;
      if (road.kind == RoadKind::kSupport) CHECK_GT(x, 19.4);
      if (road.kind == RoadKind::kSupportInterface) CHECK_LT(x, 20.6);
    }
  }
}

TEST_CASE("no bead leaves the region, whatever its shape; narrow strips have roads, too") {
  const Settings settings;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 60, 30);
    const Region some = intersect(region, rectangle_region(0, 0, 15, 30));
    for (const Road& road : support_roads(layer_of(region, some), kHeight, settings)) {
      for (std::size_t i = 0; i < road.points.size(); ++i) {
        const Point at = road.points[i];
        CHECK_GT(test::signed_distance(region, at.x, at.y),
                 static_cast<double>(width_at(road, i).units()) / 2 - 250);
      }
    }
  }
  const auto strip =
      support_roads(layer_of(rectangle_region(0, 0, 20, 0.5), {}), kHeight, settings);
  CHECK_EQ(volume_mm3(strip, kHeight, RoadKind::kSupport),
           doctest::Approx(20 * 0.5 * 0.2).epsilon(0.1));
  CHECK(support_roads(layer_of({}, {}), kHeight, settings).empty());
}

TEST_CASE("rows of the support stand on those below; on the bed it is nearly dense") {
  const Settings settings;
  const Region whole = rectangle_region(0, 0, 40, 30);
  const auto one = support_roads(layer_of(whole, {}, 7), kHeight, settings);
  const auto two = support_roads(layer_of(whole, {}, 8), kHeight, settings);
  REQUIRE_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) CHECK(one[i].points == two[i].points);
  const auto first = support_roads(layer_of(whole, {}, 0), kHeight, settings);
  CHECK_GT(volume_mm3(first, kHeight, RoadKind::kSupport), 0.85 * 1200 * 0.2);
}

TEST_CASE("layers that are alike share a plan, but for the first one") {
  SupportPlanner planner{Settings()};
  const SupportLayer some = layer_of(rectangle_region(0, 0, 9, 9), {}, 0);
  const auto first = planner.reserve(some, kHeight);
  CHECK(first.to_fill);
  SupportLayer next = some;
  next.index = 1;
  const auto second = planner.reserve(next, kHeight);
  CHECK(second.to_fill);
  next.index = 2;
  const auto third = planner.reserve(next, kHeight);
  CHECK_FALSE(third.to_fill);
  CHECK_EQ(third.plan, second.plan);
  CHECK(planner.reserve(next, Length::from_mm(0.3)).to_fill);
  CHECK_EQ(planner.reserve(layer_of({}, {}), kHeight).plan, nullptr);
  planner.fill(*second.plan);
  CHECK_FALSE(second.plan->roads.empty());
}

TEST_CASE("supports come behind the skirt and the brim, before the part") {
  const auto road = [](RoadKind kind) { return Road{kind, Length(), false, {}}; };
  const Road skirt = road(RoadKind::kSkirt), brim = road(RoadKind::kBrim);
  const Road outer = road(RoadKind::kOuterPerimeter), support = road(RoadKind::kSupport);
  const auto all = with_supports({support, support}, {skirt, brim, outer});
  REQUIRE_EQ(all.size(), 5);
  CHECK_EQ(all[1].kind, RoadKind::kBrim);
  CHECK_EQ(all[2].kind, RoadKind::kSupport);
  CHECK_EQ(all[4].kind, RoadKind::kOuterPerimeter);
  CHECK_EQ(with_supports({support}, {outer}).front().kind, RoadKind::kSupport);
}
