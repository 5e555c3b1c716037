// Travel of a motion builder: retraction, wipe, ways around contours.
#include <doctest/doctest.h>

#include <algorithm>
#include <variant>
#include <vector>

#include "core/motions/motion_builder.h"
#include "core/roads/travel_space.h"
#include "tests/core/motions/motion_samples.h"

using namespace core;
using namespace motion_test;

TEST_CASE("a travel within the part needs no retraction if so set, however long, but over tops") {
  Settings settings;
  settings.only_retract_when_crossing_perimeters = true;
  const auto retractions = [&](const char* region, const Road& last, const Road& next) {
    MotionBuilder builder(settings);
    builder.layer(slice_of(1, region), {last, next}, [](const Motion&) {});
    // Before the first road, whose filament is not known to be drawn back.
    return builder.totals().retractions - 1;
  };
  CHECK_EQ(retractions(kSquare, line(1, 1, 9, 1), line(45, 45, 1, 45)), 0);
  CHECK_EQ(retractions(kTwoSquares, line(1, 1, 9, 1), line(13, 1, 21, 1)), 1);
  for (const RoadKind top : {RoadKind::kTopSolid, RoadKind::kIroning}) {
    CHECK_EQ(retractions(kSquare, line(1, 1, 9, 1, top), line(45, 45, 1, 45)), 1);
    CHECK_EQ(retractions(kSquare, line(1, 1, 9, 1, top), line(9, 4, 1, 4)), 0);
  }
  // A skirt is outside the part: nothing is crossed from one loop to another.
  CHECK_EQ(retractions(kSquare, line(-5, -5, 55, -5, RoadKind::kSkirt),
                       line(-8, 55, -8, 0, RoadKind::kSkirt)),
           1);
}

TEST_CASE("a wipe draws back on the road; the layer above knows nothing of it") {
  Settings settings;
  settings.wipe = true;
  MotionBuilder builder(settings);
  Recorder recorder;
  for (int i = 0; i < 3; ++i) {
    builder.layer(slice_of(i, kTwoSquares), {line(1, 1, 9, 1), line(13, 1, 21, 1)},
                  recorder.sink());
    // The last road was wiped, too.
    CHECK(builder.state().retracted);
    CHECK_EQ(builder.state().position, at_mm(21 - 2.6, 1));
    CHECK(recorder.filament_moved() == doctest::Approx(-settings.retraction_mm));
    CHECK_EQ(recorder.all<Wipe>().size(), 2 * (i + 1));
  }
  // Travels begin where wipes end; the first road of a layer has its filament returned.
  const auto returned = [](const Motion& motion) {
    const auto* move = std::get_if<MoveFilament>(&motion);
    return move != nullptr && move->filament_mm == 1;
  };
  CHECK_EQ(std::count_if(recorder.motions.begin(), recorder.motions.end(), returned), 6);
  builder.finish(recorder.sink());
  CHECK(recorder.filament_moved() == doctest::Approx(-settings.retraction_mm));
  CHECK_EQ(recorder.all<Wipe>().size(), 6);
}

TEST_CASE("a travel goes the way that its space knows, from where a wipe ends, too") {
  const char* const kNotched = "0:0 20:0 20:20 12:20 12:5 8:5 8:20 0:20";
  for (const bool wipes : {false, true}) {
    CAPTURE(wipes);
    Settings settings;
    settings.wipe = wipes;
    MotionBuilder builder(settings);
    Recorder recorder;
    const Slice slice = slice_of(1, kNotched);
    const TravelSpace space(slice.region, settings.road_width, Length());
    builder.layer(slice, {line(1, 10, 7, 18), line(13, 18, 19, 18)}, recorder.sink(), &space);
    const auto travels = recorder.all<Travel>();
    REQUIRE_GE(travels.size(), 4);
    CHECK_EQ(travels.back().to, at_mm(13, 18));
    CHECK_LT(travels[1].to.y, at_mm(0, 5).y);
    CHECK_EQ(builder.totals().travels, 2);
    // Longer than retraction_travel_min.
    CHECK_EQ(builder.totals().retractions, wipes ? 3 : 2);
    CHECK_GT(builder.totals().travel_mm, 26);
  }
}
