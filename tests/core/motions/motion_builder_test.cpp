#include "core/motions/motion_builder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include "tests/core/motions/motion_samples.h"

using namespace core;
using namespace motion_test;

TEST_CASE("a print without roads never heats, and its end is silent") {
  MotionBuilder builder{Settings()};
  Recorder recorder;
  builder.layer(slice_of(0, kSquare), {}, recorder.sink());
  builder.finish(recorder.sink());
  CHECK(recorder.motions.empty());
}

TEST_CASE("the preamble comes once, with the first layer that has roads, before anything moves") {
  Settings settings;
  settings.start_gcode = {"G28", "G92 E0"};
  MotionBuilder builder(settings);
  Recorder recorder;
  builder.layer(slice_of(0, kSquare), {}, recorder.sink());
  builder.layer(slice_of(1, kSquare), {line(1, 1, 5, 1)}, recorder.sink());
  builder.layer(slice_of(2, kSquare), {line(1, 1, 5, 1)}, recorder.sink());
  const std::vector<Motion>& motions = recorder.motions;
  REQUIRE(motions.size() > 8);
  CHECK(std::holds_alternative<SetBedTemperature>(motions[0]));
  CHECK(std::holds_alternative<SetNozzleTemperature>(motions[1]));
  CHECK_EQ(std::get<Verbatim>(motions[2]).line, "G28");
  CHECK_EQ(std::get<Verbatim>(motions[3]).line, "G92 E0");
  CHECK(std::get<SetBedTemperature>(motions[4]).wait);
  CHECK(std::get<SetNozzleTemperature>(motions[5]).wait);
  CHECK_EQ(recorder.all<Verbatim>().size(), 2);
  CHECK_EQ(recorder.all<LayerStart>().size(), 2);
}

TEST_CASE("filament is length times the bead's cross-section, by kind of road") {
  MotionBuilder builder{Settings()};
  Recorder recorder;
  Road ring{RoadKind::kOuterPerimeter,
            Length::from_mm(0.5),
            true,
            {at_mm(1, 1), at_mm(11, 1), at_mm(11, 11), at_mm(1, 11)}};
  builder.layer(slice_of(0, kSquare), {ring, line(2, 2, 8, 2, RoadKind::kLoose)}, recorder.sink());
  const double around_mm = 40 - 0.06;  // seam_gap
  const double filament_mm2 = std::numbers::pi * 1.75 * 1.75 / 4;
  const double wide_mm2 = 0.2 * 0.3 + std::numbers::pi * 0.01;
  const double narrow_mm2 = 0.2 * 0.25 + std::numbers::pi * 0.01;
  double sum = 0;
  for (const Extrude& extrude : recorder.all<Extrude>()) sum += extrude.filament_mm;
  CHECK(sum == doctest::Approx((around_mm * wide_mm2 + 6 * narrow_mm2) / filament_mm2));
  const auto& by_kind = builder.totals().filament_mm;
  CHECK(by_kind[static_cast<std::size_t>(RoadKind::kOuterPerimeter)] ==
        doctest::Approx(around_mm * wide_mm2 / filament_mm2));
  CHECK(by_kind[static_cast<std::size_t>(RoadKind::kLoose)] ==
        doctest::Approx(6 * narrow_mm2 / filament_mm2));
  // A closed road comes back to where it began, but for the gap.
  CHECK_EQ(recorder.all<Extrude>()[3].to, at_mm(1, 1.06));
}

TEST_CASE("without a seam's gap a closed road ends where it began") {
  Settings settings;
  settings.seam_gap = Length();
  MotionBuilder builder(settings);
  Recorder recorder;
  const Road ring{RoadKind::kOuterPerimeter,
                  Length::from_mm(0.5),
                  true,
                  {at_mm(1, 1), at_mm(11, 1), at_mm(11, 11)}};
  builder.layer(slice_of(0, kSquare), {ring}, recorder.sink());
  CHECK_EQ(recorder.all<Extrude>().back().to, at_mm(1, 1));
}

TEST_CASE("a small perimeter is slower, with a seam's gap and without") {
  for (const double gap : {0.0, 0.06}) {
    CAPTURE(gap);
    Settings settings;
    settings.small_perimeter_speed_mm_s = 12;
    settings.cool_short_layers = false;
    settings.seam_gap = Length::from_mm(gap);
    MotionBuilder builder(settings);
    Recorder recorder;
    const Road small{RoadKind::kOuterPerimeter,
                     Length::from_mm(0.45),
                     true,
                     {at_mm(1, 1), at_mm(9, 1), at_mm(9, 9), at_mm(1, 9)}};
    builder.layer(slice_of(5, kSquare), {small}, recorder.sink());
    const auto laid = recorder.all<Extrude>();
    REQUIRE_EQ(laid.size(), 4);
    for (const Extrude& piece : laid) CHECK_EQ(piece.speed_mm_s, 12);
  }
}

TEST_CASE("what is retracted is returned, but for the retraction at the end") {
  const Settings settings;
  MotionBuilder builder(settings);
  Recorder recorder;
  for (int i = 0; i < 5; ++i) {
    builder.layer(slice_of(i, kTwoSquares), {line(1, 1, 9, 1), line(13, 1, 21, 1)},
                  recorder.sink());
    CHECK(recorder.filament_moved() == doctest::Approx(0));
  }
  builder.finish(recorder.sink());
  CHECK(recorder.filament_moved() == doctest::Approx(-settings.retraction_mm));
  CHECK_GE(builder.totals().retractions, 10);
}

TEST_CASE("retraction where a travel leaves the part or is long, and nowhere else") {
  Settings settings;
  settings.retraction_travel_min = Length::from_mm(5);
  const auto retractions = [&](const char* region, const Road& next) {
    MotionBuilder builder(settings);
    Recorder recorder;
    builder.layer(slice_of(0, region), {line(1, 1, 9, 1)}, recorder.sink());
    const auto before = builder.totals().retractions;
    builder.layer(slice_of(1, region), {next}, recorder.sink());
    return builder.totals().retractions - before;
  };
  CHECK_EQ(retractions(kSquare, line(9, 4, 1, 4)), 0);
  CHECK_EQ(retractions(kSquare, line(9, 7, 1, 7)), 1);
  CHECK_EQ(retractions(kTwoSquares, line(13, 1, 21, 1)), 1);
  // Straight on from where the nozzle is: no travel at all.
  CHECK_EQ(retractions(kSquare, line(9, 1, 1, 1)), 0);
}

TEST_CASE("a layer takes its least time where the slowest speed allows it") {
  Settings settings;
  settings.layer_time_min_s = 5;
  settings.solid_speed_mm_s = 60;
  settings.slowed_speed_min_mm_s = 10;
  MotionBuilder builder(settings);
  Recorder recorder;
  builder.layer(slice_of(0, kSquare), {line(0, 0, 1, 0)}, recorder.sink());
  builder.layer(slice_of(1, kSquare), {line(1, 0, 46, 0), line(46, 0, 1, 0)}, recorder.sink());
  CHECK(recorder.all<Extrude>().back().speed_mm_s == doctest::Approx(90.0 / 5));
}

TEST_CASE("a layer is slowed down no further than to the slowest speed") {
  Settings settings;
  settings.layer_time_min_s = 5;
  settings.slowed_speed_min_mm_s = 10;
  settings.first_layer_speed_mm_s = 30;
  MotionBuilder builder(settings);
  Recorder recorder;
  builder.layer(slice_of(0, kSquare), {line(1, 1, 3, 1)}, recorder.sink());
  CHECK(recorder.all<Extrude>().front().speed_mm_s == doctest::Approx(10));
}

TEST_CASE("the first layer is slower, the fan comes on from its layer on") {
  Settings settings;
  settings.layer_time_min_s = 0;
  settings.fan_from_layer = 3;
  settings.nozzle_first_layer_celsius = 215;
  settings.nozzle_celsius = 205;
  MotionBuilder builder(settings);
  Recorder recorder;
  for (int i = 0; i < 4; ++i) {
    builder.layer(slice_of(i, kSquare), {line(1, 1, 5, 1)}, recorder.sink());
    const auto fans = recorder.all<SetFan>();
    CHECK_EQ(fans.back().share, i >= 2 ? settings.fan_share : 0.0);
    const auto temperatures = recorder.all<SetNozzleTemperature>();
    CHECK_EQ(temperatures.back().celsius, i == 0 ? 215 : 205);
    const double speed = recorder.all<Extrude>().back().speed_mm_s;
    CHECK_EQ(speed, i == 0 ? settings.first_layer_speed_mm_s : settings.solid_speed_mm_s);
  }
}

TEST_CASE("the end lifts off the part, never above the axis, heaters off, then the user's lines") {
  for (const double axis_mm : {0.0, 4.0, 0.25}) {
    CAPTURE(axis_mm);
    Settings settings;
    settings.axis_z = Length::from_mm(axis_mm);
    settings.park_lift = Length::from_mm(10);
    settings.end_gcode = {"M84"};
    MotionBuilder builder(settings);
    Recorder recorder;
    builder.layer(slice_of(0, kSquare), {line(1, 1, 5, 1)}, recorder.sink());
    recorder.motions.clear();
    builder.finish(recorder.sink());
    const double top = axis_mm == 0 ? 10.2 : axis_mm;
    CHECK(recorder.all<Lift>().back().to.mm() == doctest::Approx(top));
    CHECK_EQ(recorder.all<Travel>().back().to, at_mm(5, 5));
    CHECK_EQ(recorder.all<SetNozzleTemperature>().back().celsius, 0);
    CHECK_EQ(recorder.all<SetBedTemperature>().back().celsius, 0);
    CHECK_EQ(std::get<Verbatim>(recorder.motions.back()).line, "M84");
    // Once only.
    const std::size_t count = recorder.motions.size();
    builder.finish(recorder.sink());
    CHECK_EQ(recorder.motions.size(), count);
  }
}

TEST_CASE("round roads become arcs only where that is decided, and lay as much") {
  Road ring{RoadKind::kPerimeter, Length::from_mm(0.45), true, {}};
  for (int i = 0; i < 200; ++i) {
    const double angle = 2 * std::numbers::pi * i / 200;
    ring.points.push_back(at_mm(25 + 10 * std::cos(angle), 25 + 10 * std::sin(angle)));
  }
  const auto built = [&ring](ArcUse use, std::optional<bool> decided) {
    Settings settings;
    settings.arcs = use;
    MotionBuilder builder(settings);
    CHECK(builder.arcs_undecided() == (use == ArcUse::kAuto));
    if (decided) builder.decide_arcs(*decided);
    Recorder recorder;
    builder.layer(slice_of(0, kSquare), {ring, line(20, 20, 30, 20)}, recorder.sink());
    CHECK(builder.totals().arcs == std::ssize(recorder.all<ExtrudeArc>()));
    double filament = 0;
    for (const Extrude& extrude : recorder.all<Extrude>()) filament += extrude.filament_mm;
    for (const ExtrudeArc& arc : recorder.all<ExtrudeArc>()) filament += arc.filament_mm;
    return std::pair(builder.totals().arcs, filament);
  };
  const auto [none, straight_mm] = built(ArcUse::kOff, std::nullopt);
  CHECK(none == 0);
  CHECK(built(ArcUse::kAuto, std::nullopt).first == 0);
  CHECK(built(ArcUse::kAuto, false).first == 0);
  CHECK(built(ArcUse::kAuto, true).first == 2);
  const auto [arcs, round_mm] = built(ArcUse::kOn, std::nullopt);
  CHECK(arcs == 2);
  CHECK(round_mm == doctest::Approx(straight_mm));
}

TEST_CASE("what was decided about arcs goes on with a print") {
  MotionBuilder first{Settings()};
  first.decide_arcs(true);
  Recorder recorder;
  first.layer(slice_of(0, kSquare), {line(1, 1, 5, 1)}, recorder.sink());
  MotionBuilder second{Settings()};
  second.resume_from(first.state());
  CHECK_FALSE(second.arcs_undecided());
  CHECK(second.state().arcs == true);
}

TEST_CASE("what is as good as straight is one piece; what a line can't carry is laid slower") {
  Road rough{RoadKind::kSolid, Length::from_mm(0.45), false, {}};
  for (int i = 0; i <= 400; ++i) rough.points.push_back(at_mm(5 + i * 0.05, 25 + i % 2 * 0.005));
  Road zigzag{RoadKind::kSolid, Length::from_mm(0.45), false, {}};
  for (int i = 0; i <= 400; ++i) zigzag.points.push_back(at_mm(5 + i * 0.05, 35 + i % 2 * 0.08));
  const auto built = [&](double time_min_ms) {
    Settings settings;
    settings.segment_time_min_ms = time_min_ms;
    settings.layer_time_min_s = 0;
    MotionBuilder builder(settings);
    Recorder recorder;
    builder.layer(slice_of(1, kSquare), {rough, zigzag}, recorder.sink());
    return recorder.all<Extrude>();
  };
  const std::vector<Extrude> all = built(0);
  const std::vector<Extrude> fewer = built(4);
  CHECK(all.size() == 401);  // the rough one, which wavers by less than the tolerance, is one
  const double full_mm_s = Settings().solid_speed_mm_s;
  double all_mm = 0, fewer_mm = 0;
  std::size_t of_rough = 0;
  for (const Extrude& piece : all) all_mm += piece.filament_mm;
  for (const Extrude& piece : fewer) {
    fewer_mm += piece.filament_mm;
    const bool is_rough = piece.to.y < at_mm(0, 30).y;
    of_rough += is_rough ? 1 : 0;
    if (is_rough) CHECK(piece.speed_mm_s == full_mm_s);
    if (!is_rough) CHECK(piece.speed_mm_s < full_mm_s / 2);
  }
  // 20 mm at 60 mm/s in pieces of 4 ms: 84 at most.
  CHECK(of_rough <= 84);
  CHECK(fewer.size() - of_rough == 400);
  CHECK(fewer_mm == doctest::Approx(all_mm));
}

TEST_CASE("a perimeter goes on without travel where less of it is held: slower, and cooled more") {
  Settings settings;
  settings.fan_share = settings.fan_share_min = 0.4;
  settings.overhang_fan_share = {0.4, 0.6, 0.8, 1};
  settings.layer_time_min_s = 0;
  MotionBuilder builder(settings);
  Recorder recorder;
  Road road{RoadKind::kOuterPerimeter,
            Length::from_mm(0.45),
            true,
            {at_mm(0, 0), at_mm(40, 0), at_mm(40, 40), at_mm(0, 40)}};
  road.holds = {Hold::kWhole, Hold::kLittle, Hold::kHalf, Hold::kWhole};
  builder.layer(slice_of(10, kSquare), {road}, recorder.sink());
  CHECK_EQ(recorder.all<RoadStart>().size(), 1);
  CHECK_EQ(recorder.all<Travel>().size(), 1);
  const auto changes = recorder.all<RoadChange>();
  REQUIRE_EQ(changes.size(), 3);
  CHECK_EQ(changes[0].kind, RoadKind::kOverhangPerimeter);
  CHECK_EQ(changes[1].kind, RoadKind::kOuterPerimeter);
  const auto laid = recorder.all<Extrude>();
  REQUIRE_EQ(laid.size(), 4);
  CHECK_EQ(laid[0].speed_mm_s, 60);
  CHECK_EQ(laid[1].speed_mm_s, settings.overhang_speed_mm_s[3]);
  CHECK_EQ(laid[2].speed_mm_s, settings.overhang_speed_mm_s[1]);
  CHECK_EQ(laid[3].speed_mm_s, 60);
  CHECK_EQ(laid[3].to, at_mm(0, 0.06));  // seam_gap
  // Off at first, the layer's, that of both stretches together, the layer's.
  const auto fans = recorder.all<SetFan>();
  REQUIRE_EQ(fans.size(), 4);
  CHECK_EQ(fans[1].share, 0.4);
  CHECK_EQ(fans[2].share, 1);
  CHECK_EQ(fans[3].share, 0.4);
  CHECK_EQ(builder.totals().filament_mm[static_cast<std::size_t>(RoadKind::kOverhangPerimeter)],
           doctest::Approx(laid[1].filament_mm));
}

TEST_CASE("what is due at a height is done once, wherever a print resumes") {
  Settings settings;
  settings.at_height = {"0.5 pause", "0.6 M117 a", "1 nozzle_celsius 220", "1.3 M117 b"};
  const auto build = [&](MotionBuilder& builder, LayerIndex from, LayerIndex to) {
    Recorder recorder;
    for (LayerIndex i = from; i < to; ++i) {
      builder.layer(slice_of(i, kSquare),
                    i == 3 ? std::vector<Road>() : std::vector{line(1, 1, 5, 1)}, recorder.sink());
    }
    return recorder;
  };
  MotionBuilder whole(settings);
  const Recorder all = build(whole, 0, 9);
  CHECK_EQ(all.all<Pause>().size(), 1);
  CHECK_EQ(all.all<Verbatim>().size(), 3);  // with the start
  CHECK_EQ(all.all<SetNozzleTemperature>().back().celsius, 220);
  CHECK_FALSE(whole.next_action().has_value());
  for (LayerIndex at = 1; at < 9; ++at) {
    CAPTURE(at);
    MotionBuilder begin(settings);
    Recorder joined = build(begin, 0, at);
    MotionBuilder rest(settings);
    rest.resume_from(begin.state());
    const Recorder more = build(rest, at, 9);
    joined.motions.insert(joined.motions.end(), more.motions.begin(), more.motions.end());
    REQUIRE_EQ(joined.motions.size(), all.motions.size());
    CHECK_EQ(joined.all<Pause>().size(), 1);
    CHECK_EQ(joined.all<Verbatim>().size(), 3);
    CHECK_EQ(joined.all<SetNozzleTemperature>().size(), all.all<SetNozzleTemperature>().size());
    for (std::size_t i = 0; i < all.motions.size(); ++i) {
      CHECK_EQ(joined.motions[i].index(), all.motions[i].index());
    }
  }
}

TEST_CASE("objects one after another: the nozzle passes over what stands, and ends above it") {
  Settings settings;
  settings.park_lift = Length::from_mm(3);
  MotionBuilder builder(settings);
  Recorder recorder;
  builder.leave_object(recorder.sink());
  CHECK(recorder.motions.empty());
  for (int index = 0; index < 10; ++index) {
    builder.layer(slice_of(index, kSquare), {line(1, 1, 5, 1)}, recorder.sink());
  }
  recorder.motions.clear();
  builder.leave_object(recorder.sink());
  REQUIRE_EQ(recorder.all<Lift>().size(), 1);
  CHECK_EQ(recorder.all<Lift>().front().to, Length::from_mm(5));
  CHECK_EQ(recorder.all<MoveFilament>().size(), 1);
  CHECK(recorder.all<Travel>().empty());
  recorder.motions.clear();
  builder.layer(slice_of(0, kSquare), {line(6, 6, 9, 6)}, recorder.sink());
  // Straight, at that height, and down at its end.
  REQUIRE_EQ(recorder.all<Travel>().size(), 1);
  REQUIRE_EQ(recorder.all<Lift>().size(), 1);
  CHECK_EQ(recorder.all<Lift>().front().to, Length::from_mm(0.2));
  const auto is = [](auto kind) {
    return [kind](const Motion& motion) { return motion.index() == Motion(kind).index(); };
  };
  const auto begin = recorder.motions.begin(), end = recorder.motions.end();
  CHECK(std::find_if(begin, end, is(Travel())) < std::find_if(begin, end, is(Lift())));
  recorder.motions.clear();
  builder.finish(recorder.sink());
  REQUIRE_EQ(recorder.all<Lift>().size(), 1);
  CHECK_EQ(recorder.all<Lift>().front().to, Length::from_mm(5));
}
