#include "core/roads/bridges.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/regions/polyline.h"
#include "core/roads/unheld.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

constexpr double kMm = kUnitsPerMm;

struct Case {
  Settings settings;
  Region slice, below, below_loose;

  [[nodiscard]] Region room() const { return inset(settings.road_width.mm() / 2 + 0.407); }
  [[nodiscard]] Region wall() const { return inset(settings.road_width.mm() + 0.407); }
  [[nodiscard]] Region inset(double mm) const {
    return offset(slice, Length::from_mm(mm), settings.arc_tolerance);
  }
  [[nodiscard]] Bridges laid() const {
    const Region around = room();
    return bridges({slice, around, below, below_loose, 6, settings.layer_height}, wall(), settings);
  }
};

double depth_mm(const Region& region, Point p) {
  return test::signed_distance(region, p.x, p.y) / kMm;
}

// Rows begin and end on what holds; at the room's edge, beyond which perimeters lie, up to half a
// road before it.
void check_held_at_both_ends(const Case& part, const std::vector<Road>& roads) {
  const Region room = part.room();
  for (const Road& road : roads) {
    if (road.kind != RoadKind::kBridge) continue;
    for (const Point end : road.points) {
      const double depth = depth_mm(part.below, end);
      const bool at_edge = std::abs(depth_mm(room, end)) < 1e-3;
      CHECK_GE(depth, at_edge ? -part.settings.road_width.mm() / 2 : -1e-3);
    }
  }
}

}  // namespace

TEST_CASE("a deck between two posts is one bridge along its span, and nothing of it is left") {
  Case part;
  part.slice = test::rectangle_region(0, 0, 28, 10);
  part.below = unite(test::rectangle_region(0, 0, 4, 10), test::rectangle_region(24, 0, 4, 10));
  const Bridges laid = part.laid();
  REQUIRE_EQ(laid.roads.size(), 1);
  const Road& road = laid.roads.front();
  CHECK_EQ(road.kind, RoadKind::kBridge);
  CHECK_EQ(road.width, bridge_width(part.settings, part.settings.layer_height));
  check_held_at_both_ends(part, laid.roads);
  for (std::size_t i = 0; i + 1 < road.points.size(); i += 2) {
    CHECK_EQ(road.points[i].y, road.points[i + 1].y);
    // One road deep on each post.
    const double low = std::min(road.points[i].x, road.points[i + 1].x) / kMm;
    const double high = std::max(road.points[i].x, road.points[i + 1].x) / kMm;
    CHECK_LE(low, 4 - 0.45);
    CHECK_GE(high, 24 + 0.45);
  }
  CHECK(intersect(laid.rest, test::rectangle_region(4, 0, 20, 10)).area_mm2() ==
        doctest::Approx(0).epsilon(0.01));
  // Neighbours touch, and a round road's area is its flow.
  const double d = road.width.mm();
  CHECK_EQ(road_area_mm2(road.kind, road.width, part.settings.layer_height),
           doctest::Approx(bead_area_mm2(part.settings.road_width, part.settings.layer_height))
               .epsilon(1e-3));
  CHECK_EQ(std::numbers::pi * d * d / 4, doctest::Approx(road_area_mm2(road.kind, road.width, {})));
  const double distance = std::abs(road.points[2].y - road.points[1].y) / kMm;
  CHECK_LE(distance, d * 1.03);
  CHECK_GE(distance, d * 0.9);
}

TEST_CASE("a step as wide as a road, and what is held on one side, are no bridges") {
  Case part;
  part.slice = test::rectangle_region(0, 0, 20, 20);
  part.below = test::rectangle_region(0.4, 0, 19.6, 20);
  CHECK(part.laid().roads.empty());
  part.below = test::rectangle_region(8, 0, 12, 20);
  const Bridges laid = part.laid();
  CHECK(laid.roads.empty());
  CHECK_EQ(test::widest_difference(laid.rest, part.wall()), 0);
}

TEST_CASE("the flow of bridges is what the user says") {
  Case part;
  for (const double flow : {0.5, 1.0, 1.6}) {
    part.settings.bridge_flow = flow;
    const Length width = bridge_width(part.settings, part.settings.layer_height);
    CHECK_EQ(
        road_area_mm2(RoadKind::kBridge, width, part.settings.layer_height),
        doctest::Approx(flow * bead_area_mm2(part.settings.road_width, part.settings.layer_height))
            .epsilon(1e-3));
  }
}

TEST_CASE("over the loose inside, rows run across the loose roads below") {
  Case part;
  part.slice = part.below = test::rectangle_region(0, 0, 30, 30);
  part.below_loose = test::rectangle_region(3, 3, 24, 24);
  const Bridges laid = part.laid();
  REQUIRE_FALSE(laid.roads.empty());
  double length = 0;
  for (const Road& road : laid.roads) {
    CHECK_EQ(road.kind, RoadKind::kInternalBridge);
    length += length_mm(road);
    for (std::size_t i = 0; i + 1 < road.points.size(); i += 2) {
      const double dx = road.points[i + 1].x - road.points[i].x;
      const double dy = road.points[i + 1].y - road.points[i].y;
      CHECK_EQ(std::abs(dx), doctest::Approx(std::abs(dy)).epsilon(0.01));  // 45° on even layers
      CHECK_GT(dx * dy, 0);
    }
  }
  CHECK(intersect(laid.rest, part.below_loose).area_mm2() < 0.1);
  // What is laid is what the place holds.
  const double area = part.wall().area_mm2() - laid.rest.area_mm2();
  CHECK_EQ(length * 0.407, doctest::Approx(area).epsilon(0.03));
  // A strip as narrow as the loose roads are apart is filled like the rest.
  part.below_loose = test::rectangle_region(3, 3, 1.5, 24);
  CHECK(part.laid().roads.empty());
}

TEST_CASE("random parts: no row begins or ends in the air, and rows cover what they take") {
  for (const unsigned seed : {11U, 12U, 13U, 14U, 15U, 16U, 17U, 18U}) {
    CAPTURE(seed);
    test::Random random(seed);
    Case part;
    part.slice = test::random_region(random, 120, 40);
    part.below = intersect(test::random_region(random, 120, 40), part.slice);
    if (part.below.empty()) continue;
    const Bridges laid = part.laid();
    check_held_at_both_ends(part, laid.roads);
    // By raster: a place of the wall that is not left for others is near a row.
    const Region wall = part.wall();
    const Region taken = subtract(wall, laid.rest);
    const double d = bridge_width(part.settings, part.settings.layer_height).mm();
    int inside = 0, covered = 0;
    for (int i = 0; i < 3'000; ++i) {
      const Point p{static_cast<std::int32_t>(random.between(-5, 45) * kMm),
                    static_cast<std::int32_t>(random.between(-5, 45) * kMm)};
      if (!taken.contains(p) || depth_mm(taken, p) < d / 2) continue;
      ++inside;
      bool near = false;
      for (const Road& road : laid.roads) {
        for (std::size_t k = 0; k + 1 < road.points.size() && !near; ++k) {
          const Segment piece{road.points[k], road.points[k + 1]};
          near = test::distance_to_segment(p, piece) <= d / 2 * 1.1 * kMm;
        }
      }
      covered += near ? 1 : 0;
    }
    CHECK_GE(covered, inside * 0.99);
    // The rest and what is taken are the wall.
    CHECK_EQ(laid.rest.area_mm2() + taken.area_mm2(), doctest::Approx(wall.area_mm2()));
  }
}

TEST_CASE("what is unheld is farther than the reach from the slice below") {
  for (const unsigned seed : {31U, 32U, 33U, 34U}) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region slice = test::random_region(random, 150, 30);
    const Region below = seed % 2 == 0 ? test::random_region(random, 150, 30)
                                       : offset(slice, Length::from_mm(0.3), Length::from_mm(0.01));
    for (const double reach : {0.1, 0.29, 0.31, 1.0}) {
      const Region air = unheld(slice, below, Length::from_mm(reach));
      for (int i = 0; i < 2'000; ++i) {
        const double x = random.between(-5, 35) * kMm, y = random.between(-5, 35) * kMm;
        const double in_slice = test::signed_distance(slice, x, y);
        const double away = below.empty() ? 1e9 : -test::signed_distance(below, x, y);
        // Near the borders both answers are right.
        if (std::abs(in_slice) < 200 || std::abs(away - reach * kMm) < 200) continue;
        const Point p{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
        CHECK_EQ(air.contains(p), in_slice > 0 && away > reach * kMm);
      }
    }
  }
}
