#include "core/motions/height_actions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>
#include <variant>
#include <vector>

#include "tests/core/motions/motion_samples.h"

using namespace core;
using namespace motion_test;
using Kind = HeightAction::Kind;

namespace {

HeightAction read_line(const char* text) {
  const auto action = core::read_height_action(text);
  REQUIRE(action.ok());
  return action.value();
}

core::HeightActions actions_of(std::vector<std::string> lines) {
  core::Settings settings;
  settings.at_height = std::move(lines);
  return core::HeightActions(settings);
}

}  // namespace

TEST_CASE("a line is a height and what is done there") {
  CHECK(read_line("12.4 pause").kind == Kind::kPause);
  CHECK_EQ(read_line("12.4 pause").height, Length::from_mm(12.4));
  CHECK_EQ(read_line("  0.0001\tpause ").height, Length::from_units(1));
  CHECK_EQ(read_line("1.20000 pause").height, Length::from_mm(1.2));
  CHECK_EQ(read_line(".5 pause").height, Length::from_mm(0.5));
  CHECK(read_line("30 nozzle_celsius 220.5").kind == Kind::kValue);
  CHECK_EQ(read_line("30 nozzle_celsius 220.5").setting->key, "nozzle_celsius");
  CHECK_EQ(read_line("30 nozzle_celsius 220.5").value, 220.5);
  CHECK_EQ(read_line("30 pressure_advance_s 0.045").value, 0.045);
  CHECK_EQ(read_line("30 retraction_mm 0").value, 0);
  CHECK(read_line("30 gcode M117 half of it").kind == Kind::kGcode);
  CHECK_EQ(read_line("30 gcode M117 half of it").line, "M117 half of it");
  CHECK_EQ(read_line("30 M600").line, "M600");
  CHECK_EQ(read_line("30 TIMELAPSE_TAKE A=1").line, "TIMELAPSE_TAKE A=1");
  CHECK_EQ(read_line("30 gcode m600").line, "m600");
}

TEST_CASE("other lines are refused") {
  for (const char* text : {"",
                           "pause",
                           "0 pause",
                           "-1 pause",
                           "1e3 pause",
                           "1.2.3 pause",
                           "0.00001 pause",
                           "1000001 pause",
                           "99999999999999999999 pause",
                           ". pause",
                           "5",
                           "5 pase",
                           "5 pause now",
                           "5 gcode",
                           "5 nozzle_celsius",
                           "5 nozzle_celsius hot",
                           "5 nozzle_celsius 501",
                           "5 nozzle_celsius 2.05",
                           "5 m600",
                           "5 extrusion_multiplier 0",
                           "5 retraction_mm -1",
                           "5 layer_height 0.2"}) {
    CAPTURE(text);
    const auto action = core::read_height_action(text);
    CHECK_FALSE(action.ok());
    CHECK(action.error().message.size() > 20);
  }
}

TEST_CASE("an action is due once, before the first layer that starts at its height or above") {
  const core::HeightActions actions =
      actions_of({"3 M117 c", "0.5 M117 a", "3 M117 d", "0.6 M117 b", "2 nozzle_celsius 220"});
  const auto due = [&](std::size_t done, double mm) {
    std::string lines;
    for (const HeightAction& action : actions.due(done, Length::from_mm(mm))) {
      lines += action.line.empty() ? "t" : action.line.substr(5);
    }
    return lines;
  };
  CHECK_EQ(due(0, 0.4), "");
  CHECK_EQ(due(0, 0.6), "ab");
  CHECK_EQ(due(2, 0.6), "");
  CHECK_EQ(due(2, 3), "tcd");
  CHECK_EQ(due(5, 100), "");
  CHECK_EQ(actions.height_of(0), Length::from_mm(0.5));
  CHECK_FALSE(actions.height_of(5).has_value());
}

TEST_CASE("a value holds from its height to the next one's") {
  const core::HeightActions actions =
      actions_of({"3 nozzle_celsius 230", "1 nozzle_celsius 220", "2 retraction_mm 0.4"});
  const auto at = [&](double mm) {
    core::Settings settings;
    settings.nozzle_celsius = 205;
    actions.apply(actions.due(0, Length::from_mm(mm)).size(), settings);
    return settings;
  };
  CHECK_EQ(at(0.9).nozzle_celsius, 205);
  CHECK_EQ(at(1).nozzle_celsius, 220);
  CHECK_EQ(at(2.9).nozzle_celsius, 220);
  CHECK_EQ(at(99).nozzle_celsius, 230);
  CHECK_EQ(at(1.9).retraction_mm, core::Settings().retraction_mm);
  CHECK_EQ(at(2).retraction_mm, 0.4);
}

namespace {

Settings varied_settings() {
  Settings settings;
  settings.wipe = true;  // filament is drawn back between layers, with the length of the one below
  settings.retraction_mm = 1;
  settings.pressure_advance_s = 0.02;
  settings.volumetric_speed_max_mm3_s = 1;
  settings.cool_short_layers = false;
  settings.at_height = {"0.4 retraction_mm 0.25", "0.4 pressure_advance_s 0.05",
                        "0.8 retraction_mm 2",    "0.8 volumetric_speed_max_mm3_s 2",
                        "1.2 retraction_mm 0",    "1.2 extrusion_multiplier 0.5",
                        "1.4 retraction_mm 1.5",  "1.4 pressure_advance_s 0.01"};
  return settings;
}

constexpr LayerIndex kLayers = 10;

void build(MotionBuilder& builder, LayerIndex from, LayerIndex to, Recorder& recorder) {
  for (LayerIndex i = from; i < to; ++i) {
    builder.layer(slice_of(i, kTwoSquares), {line(1, 1, 9, 1), line(13, 1, 21, 1)},
                  recorder.sink());
  }
}

Recorder whole_print(const Settings& settings) {
  Recorder all;
  MotionBuilder whole(settings);
  build(whole, 0, kLayers, all);
  whole.finish(all.sink());
  return all;
}

}  // namespace

TEST_CASE("values of settings hold from their heights on") {
  const Recorder all = whole_print(varied_settings());
  const auto wanted_mm = [](int layer) {
    return layer < 2 ? 1 : layer < 4 ? 0.25 : layer < 6 ? 2 : layer < 7 ? 0 : 1.5;
  };
  int layer = -1;
  double drawn_mm = 0, deepest_mm = 0, thin_mm = 0;
  int roads = 0;
  for (const Motion& motion : all.motions) {
    if (const auto* start = std::get_if<LayerStart>(&motion))
      layer = static_cast<int>(start->index);
    if (const auto* move = std::get_if<MoveFilament>(&motion)) drawn_mm -= move->filament_mm;
    if (const auto* wipe = std::get_if<Wipe>(&motion)) drawn_mm -= wipe->filament_mm;
    if (std::holds_alternative<Travel>(motion)) deepest_mm = drawn_mm;
    const auto* road = std::get_if<Extrude>(&motion);
    if (road == nullptr) continue;
    CAPTURE(layer);
    CHECK(drawn_mm == doctest::Approx(0));
    CHECK(deepest_mm == doctest::Approx(wanted_mm(layer)));
    const double area_mm2 = bead_area_mm2(Length::from_mm(0.45), Length::from_mm(0.2));
    const double flow = layer < 6 ? 1 : 0.5;
    if (layer > 0) {
      const double fastest = std::min(60.0, (layer < 4 ? 1 : 2) / (area_mm2 * flow));
      CHECK(road->speed_mm_s == doctest::Approx(fastest));
    }
    if (roads++ == 0) thin_mm = road->filament_mm;
    CHECK(road->filament_mm == doctest::Approx(thin_mm * flow));
  }
  CHECK_EQ(roads, 2 * kLayers);
  const auto advances = all.all<SetPressureAdvance>();
  REQUIRE_EQ(advances.size(), 4);
  for (int i = 0; i < 4; ++i) {
    CHECK_EQ(advances[static_cast<std::size_t>(i)].seconds,
             std::array{0.02, 0.05, 0.01, 0.02}[static_cast<std::size_t>(i)]);
  }
}

TEST_CASE("values hold wherever a print resumes") {
  const Settings settings = varied_settings();
  const Recorder all = whole_print(settings);
  const auto laid_whole = all.all<Extrude>();
  for (LayerIndex at = 1; at < kLayers; ++at) {
    CAPTURE(at);
    MotionBuilder begin(settings);
    Recorder joined;
    build(begin, 0, at, joined);
    MotionBuilder rest(settings);
    rest.resume_from(begin.state());
    build(rest, at, kLayers, joined);
    rest.finish(joined.sink());
    REQUIRE_EQ(joined.motions.size(), all.motions.size());
    CHECK(joined.filament_moved() == doctest::Approx(all.filament_moved()));
    CHECK_EQ(joined.all<SetPressureAdvance>().size(), 4);
    const auto laid = joined.all<Extrude>();
    for (std::size_t i = 0; i < laid.size(); ++i) {
      CHECK_EQ(laid[i].speed_mm_s, laid_whole[i].speed_mm_s);
      CHECK_EQ(laid[i].filament_mm, laid_whole[i].filament_mm);
    }
  }
}
