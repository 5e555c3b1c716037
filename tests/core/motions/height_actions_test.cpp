#include "core/motions/height_actions.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using core::HeightAction;
using core::Length;
using Kind = HeightAction::Kind;

namespace {

HeightAction read(const char* text) {
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
  CHECK(read("12.4 pause").kind == Kind::kPause);
  CHECK_EQ(read("12.4 pause").height, Length::from_mm(12.4));
  CHECK_EQ(read("  0.0001\tpause ").height, Length::from_units(1));
  CHECK_EQ(read("1.20000 pause").height, Length::from_mm(1.2));
  CHECK_EQ(read(".5 pause").height, Length::from_mm(0.5));
  CHECK(read("30 nozzle_celsius 220.5").kind == Kind::kNozzleTemperature);
  CHECK_EQ(read("30 nozzle_celsius 220.5").celsius, 220.5);
  CHECK(read("30 gcode M117 half of it").kind == Kind::kGcode);
  CHECK_EQ(read("30 gcode M117 half of it").line, "M117 half of it");
  CHECK_EQ(read("30 M600").line, "M600");
  CHECK_EQ(read("30 TIMELAPSE_TAKE A=1").line, "TIMELAPSE_TAKE A=1");
  CHECK_EQ(read("30 gcode m600").line, "m600");
}

TEST_CASE("other lines are refused") {
  for (const char* text :
       {"", "pause", "0 pause", "-1 pause", "1e3 pause", "1.2.3 pause", "0.00001 pause",
        "1000001 pause", "99999999999999999999 pause", ". pause", "5", "5 pase", "5 pause now",
        "5 gcode", "5 nozzle_celsius", "5 nozzle_celsius hot", "5 nozzle_celsius 501",
        "5 nozzle_celsius 2.05", "5 m600"}) {
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

TEST_CASE("a temperature holds from its height to the next one's") {
  const core::HeightActions actions =
      actions_of({"3 nozzle_celsius 230", "1 nozzle_celsius 220", "2 pause"});
  CHECK_FALSE(actions.nozzle_celsius(Length::from_mm(0.9)).has_value());
  CHECK_EQ(actions.nozzle_celsius(Length::from_mm(1)), 220);
  CHECK_EQ(actions.nozzle_celsius(Length::from_mm(2.9)), 220);
  CHECK_EQ(actions.nozzle_celsius(Length::from_mm(99)), 230);
}
