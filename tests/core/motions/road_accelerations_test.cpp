#include "core/motions/road_accelerations.h"

#include <doctest/doctest.h>

#include <variant>
#include <vector>

#include "core/motions/motion_builder.h"

using namespace core;

namespace {

Settings accelerations() {
  Settings settings;
  settings.default_acceleration_mm_s2 = 1'000;
  settings.perimeter_acceleration_mm_s2 = 900;
  settings.outer_perimeter_acceleration_mm_s2 = 500;
  settings.loose_acceleration_mm_s2 = 2'000;
  settings.solid_acceleration_mm_s2 = 1'500;
  settings.top_acceleration_mm_s2 = 700;
  settings.bridge_acceleration_mm_s2 = 400;
  settings.first_layer_acceleration_mm_s2 = 300;
  settings.travel_acceleration_mm_s2 = 3'000;
  return settings;
}

double on_layer(const Settings& settings, LayerIndex layer, RoadKind kind) {
  return road_acceleration_mm_s2(settings, layer, Length::from_mm(2), kind);
}

Slice slice_at(LayerIndex index) {
  Slice slice;
  slice.index = index;
  slice.height = Length::from_mm(0.2);
  slice.bottom = slice.height * index;
  return slice;
}

Road line(int y_mm, RoadKind kind) {
  return {kind, Length::from_mm(0.45), false, {{10'000, y_mm * 10'000}, {200'000, y_mm * 10'000}}};
}

// What is told, and which kinds of moves come between: 'r' a road, 't' travel.
struct Told {
  std::vector<double> mm_s2;
  std::string order;

  MotionBuilder::Sink sink() {
    return [this](const Motion& motion) {
      if (const auto* set = std::get_if<SetAcceleration>(&motion)) {
        mm_s2.push_back(set->mm_s2);
        order += 'a';
      }
      if (std::holds_alternative<Travel>(motion)) order += 't';
      if (std::holds_alternative<Extrude>(motion)) order += 'r';
    };
  }
};

}  // namespace

TEST_CASE("a kind of road has its own acceleration, or that of the next in order") {
  Settings settings = accelerations();
  CHECK_EQ(on_layer(settings, 5, RoadKind::kOuterPerimeter), 500);
  CHECK_EQ(on_layer(settings, 5, RoadKind::kOverhangPerimeter), 400);
  CHECK_EQ(on_layer(settings, 5, RoadKind::kPerimeter), 900);
  CHECK_EQ(on_layer(settings, 5, RoadKind::kBridge), 400);
  CHECK_EQ(on_layer(settings, 5, RoadKind::kInternalBridge), 400);
  CHECK_EQ(on_layer(settings, 5, RoadKind::kTopSolid), 700);
  CHECK_EQ(on_layer(settings, 5, RoadKind::kIroning), 700);
  CHECK_EQ(on_layer(settings, 5, RoadKind::kSolid), 1'500);
  CHECK_EQ(on_layer(settings, 5, RoadKind::kBottomSolid), 1'500);
  CHECK_EQ(on_layer(settings, 5, RoadKind::kLoose), 2'000);
  CHECK_EQ(on_layer(settings, 5, RoadKind::kGapFill), 1'000);
  CHECK_EQ(on_layer(settings, 0, RoadKind::kSkirt), 300);
  CHECK_EQ(on_layer(settings, 0, RoadKind::kOuterPerimeter), 300);
  CHECK_EQ(travel_acceleration_mm_s2(settings, Length()), 3'000);

  settings.first_layer_acceleration_mm_s2 = settings.outer_perimeter_acceleration_mm_s2 = 0;
  settings.bridge_acceleration_mm_s2 = settings.top_acceleration_mm_s2 = 0;
  CHECK_EQ(on_layer(settings, 0, RoadKind::kOuterPerimeter), 900);
  CHECK_EQ(on_layer(settings, 5, RoadKind::kOverhangPerimeter), 900);
  CHECK_EQ(on_layer(settings, 5, RoadKind::kBridge), 2'000);
  CHECK_EQ(on_layer(settings, 5, RoadKind::kTopSolid), 1'500);
  settings.solid_acceleration_mm_s2 = 0;
  CHECK_EQ(on_layer(settings, 5, RoadKind::kTopSolid), 2'000);
  settings.loose_acceleration_mm_s2 = settings.perimeter_acceleration_mm_s2 = 0;
  for (int kind = 0; kind < kRoadKindCount; ++kind) {
    CHECK_EQ(on_layer(settings, 5, static_cast<RoadKind>(kind)), 1'000);
  }
}

TEST_CASE("without a default no acceleration is told") {
  Settings settings = accelerations();
  settings.default_acceleration_mm_s2 = 0;
  MotionBuilder builder(settings);
  Told told;
  builder.layer(slice_at(0), {line(1, RoadKind::kSolid)}, told.sink());
  builder.finish(told.sink());
  CHECK(told.mm_s2.empty());
}

TEST_CASE("an acceleration is told before the first move that needs another one, and given back") {
  Settings settings = accelerations();
  settings.travel_acceleration_mm_s2 = 0;
  MotionBuilder builder(settings);
  Told told;
  builder.layer(slice_at(3),
                {line(1, RoadKind::kOuterPerimeter), line(2, RoadKind::kOuterPerimeter),
                 line(3, RoadKind::kSolid), line(4, RoadKind::kBottomSolid)},
                told.sink());
  CHECK_EQ(told.mm_s2, std::vector<double>{500, 1'500});
  CHECK_EQ(told.order, "tartrtartr");
  // The state goes on with the print: nothing is told twice.
  MotionBuilder rest(settings);
  rest.resume_from(builder.state());
  Told then;
  rest.layer(slice_at(4), {line(1, RoadKind::kSolid)}, then.sink());
  CHECK(then.mm_s2.empty());
  rest.finish(then.sink());
  CHECK_EQ(then.mm_s2, std::vector<double>{1'000});
}

TEST_CASE("travel with an acceleration of its own") {
  MotionBuilder builder(accelerations());
  Told told;
  builder.layer(slice_at(3), {line(1, RoadKind::kLoose), line(2, RoadKind::kLoose)}, told.sink());
  CHECK_EQ(told.mm_s2, std::vector<double>{3'000, 2'000, 3'000, 2'000});
  CHECK_EQ(told.order, "ataratar");
}
