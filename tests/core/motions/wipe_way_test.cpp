#include "core/motions/wipe_way.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "core/regions/polyline.h"
#include "core/regions/segment_grid.h"
#include "core/roads/road.h"
#include "tests/support/random_regions.h"

using namespace core;

namespace {

Point at_mm(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x * kUnitsPerMm)),
          static_cast<std::int32_t>(std::lround(y * kUnitsPerMm))};
}

double drawn_mm(const WipePlan& plan) {
  return plan.before_mm + plan.filament_per_mm * length_mm(plan.way, false);
}

Settings wiping() {
  Settings settings;
  settings.wipe = true;
  return settings;
}

}  // namespace

TEST_CASE("an open road is wiped backwards, a closed one over its start") {
  const Settings settings = wiping();
  // 1 mm at 40 mm/s, while the nozzle moves at 4/5 of 130 mm/s.
  const double as_far = 104 * 0.025;
  const std::vector<Point> open = {at_mm(0, 0), at_mm(10, 0), at_mm(10, 1)};
  const WipePlan back = wipe_plan(open, false, settings);
  CHECK_EQ(back.way, (std::vector<Point>{at_mm(10, 1), at_mm(10, 0), at_mm(8.4, 0)}));
  CHECK_EQ(back.speed_mm_s, doctest::Approx(104));
  CHECK_EQ(back.before_mm, 0);
  CHECK_EQ(length_mm(back.way, false), doctest::Approx(as_far));
  const std::vector<Point> loop = {at_mm(0, 0), at_mm(2, 0), at_mm(2, 2), at_mm(0, 2),
                                   at_mm(0, 0.06)};
  const WipePlan on = wipe_plan(loop, true, settings);
  CHECK_EQ(on.way, (std::vector<Point>{at_mm(0, 0.06), at_mm(0, 0), at_mm(2, 0), at_mm(2, 0.54)}));
}

TEST_CASE("a distance and a share before it; what a short road cannot take is drawn before") {
  Settings settings = wiping();
  settings.wipe_distance = Length::from_mm(1.5);
  settings.retraction_before_wipe = 0.25;
  const std::vector<Point> road = {at_mm(0, 0), at_mm(20, 0)};
  WipePlan plan = wipe_plan(road, false, settings);
  CHECK_EQ(plan.before_mm, doctest::Approx(0.25));
  CHECK_EQ(length_mm(plan.way, false), doctest::Approx(1.5));
  CHECK_EQ(plan.filament_per_mm * plan.speed_mm_s, doctest::Approx(40));
  plan = wipe_plan({at_mm(0, 0), at_mm(1, 0)}, false, settings);
  CHECK_EQ(length_mm(plan.way, false), doctest::Approx(1));
  CHECK_EQ(plan.before_mm, doctest::Approx(0.25 + 0.75 / 3));
  // Slower than the filament could be drawn, where the nozzle would be too fast.
  settings.wipe_distance = Length::from_mm(10);
  plan = wipe_plan(road, false, settings);
  CHECK_EQ(plan.speed_mm_s, doctest::Approx(104));
  settings.retraction_before_wipe = 1;
  plan = wipe_plan(road, false, settings);
  CHECK(plan.way.empty());
  CHECK_EQ(plan.before_mm, 1);
}

TEST_CASE("random roads: a wipe stays on the road, and draws back what a retraction does") {
  constexpr std::uint64_t kSeed = 4'711;
  test::Random random(kSeed);
  for (int round = 0; round < 400; ++round) {
    CAPTURE(kSeed);
    CAPTURE(round);
    Settings settings = wiping();
    settings.retraction_before_wipe = round % 3 * 0.4;
    if (round % 2 == 1) settings.wipe_distance = Length::from_mm(random.between(0.1, 8));
    const bool closed = round % 4 < 2;
    Road road{
        RoadKind::kPerimeter, Length::from_mm(0.45), closed,
        test::random_blob(random, random.integer(3, 60), 10, 10, random.between(0.2, 4), 0.3)};
    std::vector<Segment> laid;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < road.points.size(); ++i) {
      laid.push_back({road.points[i], road.points[(i + 1) % road.points.size()]});
    }
    // Straight over the seam's gap, however many corners it had.
    const Length gap = closed ? Length::from_units(settings.seam_gap.units() / 2) : Length();
    const SegmentGrid on_road(Length::from_mm(1), laid);
    if (closed) road = opened(std::move(road), settings.seam_gap);
    const WipePlan plan = wipe_plan(road.points, closed, settings);
    CHECK(drawn_mm(plan) == doctest::Approx(settings.retraction_mm));
    CHECK_GE(plan.before_mm, -1e-9);
    CHECK_LE(plan.filament_per_mm * plan.speed_mm_s, settings.retraction_speed_mm_s + 1e-6);
    REQUIRE(!plan.way.empty());
    CHECK_EQ(plan.way.front(), road.points.back());
    for (std::size_t i = 1; i < plan.way.size(); ++i) {
      for (int k = 0; k <= 10; ++k) {
        const Point at = between(plan.way[i - 1], plan.way[i], k / 10.0);
        REQUIRE(on_road.any_within(at, settings.segment_tolerance + gap + Length::from_units(3)));
      }
    }
  }
}
