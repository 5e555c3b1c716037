// Roads that pass through areas with speeds and flows of their own: a piece has those of an area if
// and only if it lies within it.
#include "core/motions/laid_areas.h"

#include <doctest/doctest.h>

#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "core/motions/road_speeds.h"
#include "core/regions/polyline.h"
#include "tests/core/motions/motion_samples.h"
#include "tests/support/random_regions.h"

using core::AreaChange;
using core::ChangedAreas;
using core::LaidAreas;
using core::LaidValue;
using core::Length;
using core::Point;
using core::Region;
using core::Road;
using core::RoadKind;
using core::Settings;
using core::WidthStretch;
using motion_test::at_mm;
using motion_test::Recorder;

namespace {

constexpr Length kHeight = Length::from_units(2'000);

std::shared_ptr<const ChangedAreas> shared(ChangedAreas areas) {
  return std::make_shared<const ChangedAreas>(std::move(areas));
}

AreaChange with(LaidValue which, double value) {
  AreaChange change;
  change.value(which) = value;
  return change;
}

Region box_mm(double x0, double y0, double x1, double y1) {
  return Region::from_clean_rings({{at_mm(x0, y0), at_mm(x1, y0), at_mm(x1, y1), at_mm(x0, y1)}});
}

// What holds at a point: nothing where a border is near.
std::optional<AreaChange> holding_at(const ChangedAreas& areas, Point point, Length border) {
  AreaChange change;
  for (const core::ChangedArea& area : areas) {
    if (core::SegmentGrid(Length::from_mm(1), area.region).any_within(point, border)) return {};
    if (area.region.contains(point)) change = merged(change, area.change);
  }
  return change;
}

Road random_road(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-12, 12);
  Road road{RoadKind::kPerimeter, Length::from_mm(0.45), random() % 2 == 0, {}};
  for (std::size_t i = 0, count = 3 + random() % 12; i < count; ++i) {
    road.points.push_back(at_mm(place(random), place(random)));
  }
  return road;
}

}  // namespace

TEST_CASE("random roads and areas: pieces are the road, each with what holds where it lies") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  test::Random regions(seed);
  int within = 0, outside = 0;
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    ChangedAreas areas;
    for (int i = 0, count = 1 + static_cast<int>(random() % 3); i < count; ++i) {
      AreaChange change = with(LaidValue::kPerimeterSpeed, 20 + 10 * i);
      if (i == 1) change = with(LaidValue::kPerimeterFlow, 0.5);
      Region region = test::random_region(regions, 20, 20);
      areas.push_back({change, std::move(region)});
    }
    const Settings settings;
    const LaidAreas laid(shared(areas), settings);
    const Road road = random_road(random);
    const std::vector<WidthStretch> stretches = laid.cut(width_stretches(road, kHeight));
    REQUIRE_FALSE(stretches.empty());
    double length = 0;
    Point last = road.points.front();
    const double whole_mm2 = core::bead_area_mm2(road.width, kHeight);
    for (const WidthStretch& stretch : stretches) {
      CHECK_EQ(stretch.points.front(), last);
      last = stretch.closed ? stretch.points.front() : stretch.points.back();
      length += core::length_mm(stretch.points, stretch.closed);
      const Settings* own = laid.settings_of(stretch);
      const double speed = (own != nullptr ? *own : settings).perimeter_speed_mm_s;
      for (std::size_t i = 1; i < stretch.points.size(); ++i) {
        const Point from = stretch.points[i - 1], to = stretch.points[i];
        for (double share = 0.05; share < 1; share += 0.1) {
          const auto holds =
              holding_at(areas, core::between(from, to, share), core::kAreaPieceMin * 2);
          if (!holds) continue;
          CHECK_EQ(speed, holds->value(LaidValue::kPerimeterSpeed).value_or(60));
          CHECK_EQ(stretch.area_mm2 / whole_mm2,
                   doctest::Approx(holds->value(LaidValue::kPerimeterFlow).value_or(1)));
          ++(*holds == AreaChange() ? outside : within);
        }
      }
    }
    CHECK_EQ(last, road.closed ? road.points.front() : road.points.back());
    CHECK_EQ(length, doctest::Approx(core::length_mm(road)).epsilon(1e-5));
  }
  CHECK_GT(within, 100);
  CHECK_GT(outside, 100);
}

TEST_CASE("each kind of road has its own speed and flow, and skirts none") {
  const std::vector<std::pair<LaidValue, RoadKind>> speeds{
      {LaidValue::kPerimeterSpeed, RoadKind::kPerimeter},
      {LaidValue::kOuterPerimeterSpeed, RoadKind::kOuterPerimeter},
      {LaidValue::kBridgeSpeed, RoadKind::kBridge},
      {LaidValue::kInternalBridgeSpeed, RoadKind::kInternalBridge},
      {LaidValue::kSolidSpeed, RoadKind::kSolid},
      {LaidValue::kTopSpeed, RoadKind::kTopSolid},
      {LaidValue::kIroningSpeed, RoadKind::kIroning},
      {LaidValue::kLooseSpeed, RoadKind::kLoose},
      {LaidValue::kRestSpeed, RoadKind::kGapFill}};
  for (const auto& [value, of_kind] : speeds) {
    const RoadKind kind = of_kind;  // CAPTURE() is a lambda
    CAPTURE(static_cast<int>(kind));
    const Settings settings, changed = laid_settings(settings, with(value, 7));
    CHECK_EQ(core::full_speed_mm_s(changed, 4, {kind}), 7);
    for (const auto& [other, other_kind] : speeds) {
      if (other_kind == kind) continue;
      CHECK_EQ(core::full_speed_mm_s(changed, 4, {other_kind}),
               core::full_speed_mm_s(settings, 4, {other_kind}));
    }
  }
  const std::vector<std::pair<LaidValue, RoadKind>> flows{
      {LaidValue::kPerimeterFlow, RoadKind::kPerimeter},
      {LaidValue::kOuterPerimeterFlow, RoadKind::kOuterPerimeter},
      {LaidValue::kOverhangFlow, RoadKind::kOverhangPerimeter},
      {LaidValue::kBridgeFlow, RoadKind::kBridge},
      {LaidValue::kInternalBridgeFlow, RoadKind::kInternalBridge},
      {LaidValue::kSolidFlow, RoadKind::kSolid},
      {LaidValue::kTopFlow, RoadKind::kTopSolid},
      {LaidValue::kBottomFlow, RoadKind::kBottomSolid},
      {LaidValue::kLooseFlow, RoadKind::kLoose},
      {LaidValue::kGapFlow, RoadKind::kGapFill}};
  for (const auto& [value, of_kind] : flows) {
    const RoadKind kind = of_kind;
    CAPTURE(static_cast<int>(kind));
    AreaChange change = with(value, 0.5);
    change.value(LaidValue::kFlow) = 3;
    CHECK_EQ(flow_share(change, kind), 1.5);
    CHECK_EQ(flow_share(change, kind == RoadKind::kLoose ? RoadKind::kSolid : RoadKind::kLoose), 3);
    CHECK_EQ(flow_share(change, RoadKind::kSkirt), 1);
    CHECK_EQ(flow_share(change, RoadKind::kSupport), 1);
  }
}

TEST_CASE("what is laid: speed and filament change at the border, and the nozzle does not stop") {
  Settings settings;
  settings.layer_time_min_s = 0;
  core::Slice slice = motion_test::slice_of(3, motion_test::kSquare);
  AreaChange change = with(LaidValue::kSolidSpeed, 20);
  change.value(LaidValue::kFlow) = 1.5;
  slice.areas = shared({{change, box_mm(20, -5, 60, 30)}});
  core::MotionBuilder builder(settings);
  Recorder recorder;
  builder.layer(slice, {motion_test::line(5, 10, 45, 10), motion_test::line(45, 40, 5, 40)},
                recorder.sink());
  const auto laid = recorder.all<core::Extrude>();
  REQUIRE_EQ(laid.size(), 3);
  CHECK_EQ(laid[0].to, at_mm(20, 10));
  CHECK_EQ(laid[0].speed_mm_s, 60);
  CHECK_EQ(laid[1].speed_mm_s, 20);
  CHECK_EQ(laid[2].speed_mm_s, 60);
  CHECK_EQ(laid[1].filament_mm / 25, doctest::Approx(1.5 * laid[0].filament_mm / 15));
  CHECK_EQ(laid[2].filament_mm / 40, doctest::Approx(laid[0].filament_mm / 15));
  CHECK_EQ(recorder.all<core::RoadStart>().size(), 2);
}

TEST_CASE("a limit of the volume counts what an area's flow lays") {
  Settings settings;
  settings.layer_time_min_s = 0;
  settings.volumetric_speed_max_mm3_s = 2;
  core::Slice slice = motion_test::slice_of(3, motion_test::kSquare);
  slice.areas = shared({{with(LaidValue::kFlow, 2), box_mm(20, -5, 60, 60)}});
  core::MotionBuilder builder(settings);
  Recorder recorder;
  builder.layer(slice, {motion_test::line(5, 10, 45, 10)}, recorder.sink());
  const auto laid = recorder.all<core::Extrude>();
  REQUIRE_EQ(laid.size(), 2);
  CHECK_EQ(laid[1].speed_mm_s, doctest::Approx(laid[0].speed_mm_s / 2));
}

TEST_CASE("areas that change nothing of how roads are laid leave no trace") {
  const Road road = motion_test::line(0, 0, 40, 0);
  AreaChange density;
  density.density = 0.5;
  const LaidAreas laid(shared({{density, box_mm(10, -5, 20, 5)}}), Settings());
  const auto stretches = laid.cut(width_stretches(road, kHeight));
  REQUIRE_EQ(stretches.size(), 1);
  CHECK_EQ(stretches.front().area, WidthStretch::kNoArea);
}
