// What of the tool, the factors, accelerations and pressure advance is told again behind lines.
#include "host/pipeline/standing_values.h"

#include <doctest/doctest.h>

using Lines = std::vector<std::string>;

namespace {

core::Settings started(Lines start) {
  core::Settings settings;
  settings.start_gcode = std::move(start);
  return settings;
}

Lines again(const Lines& start, const Lines& lines) {
  return host::StandingValues(started(start)).told_again_after(lines);
}

bool loses(const Lines& start, const Lines& lines) {
  return host::StandingValues(started(start)).loses_value(lines);
}

}  // namespace

TEST_CASE("lines that change nothing of it need nothing") {
  const Lines nothing;
  CHECK(again({}, {}) == nothing);
  CHECK(again({"T1", "M220 S80"},
              {"M600", "M0", "M117 T1 M220 S50", "; M220 S50", "M104 T1 S200"}) == nothing);
  CHECK(again({}, {"M220", "M221", "M900", "M204", "M220 B"}) == nothing);  // these ask, or note
  CHECK(again({}, {"T1", "M220 S50", "T0", "M220 S100"}) == nothing);
  CHECK(again({"M221 S95"}, {"M221 S120", "M221 S95.0"}) == nothing);
}

TEST_CASE("the tool and the factors go back to what start G-code says, or to a new controller's") {
  CHECK(again({}, {"M220 S50", "M221 S90", "T1"}) == Lines{"T0", "M220 S100", "M221 S100"});
  CHECK(again({"T0", "T2 ; this one", "M220 S80", "m221 s95"}, {"T1", "m220s50", "M221 S90"}) ==
        Lines{"T2", "M220 S80", "M221 S95"});
  CHECK(again({"M220 S80"}, {"M220 B", "M220 S100", "G1 X5", "M220 R"}) == Lines{"M220 S80"});
  CHECK(again({"M221 S95", "M221 S90 T1"}, {"M221 T1 S80", "M221 T0 S70"}) ==
        Lines{"M221 S90 T1", "M221 S95"});
  CHECK(again({}, {"M221 D1 S80"}) == Lines{"M221 S100 D1"});
  CHECK(again({}, {"ACTIVATE_EXTRUDER EXTRUDER=extruder1"}) ==
        Lines{"ACTIVATE_EXTRUDER EXTRUDER=extruder"});
  // Several commands in a line, as RepRapFirmware runs them.
  CHECK(again({"G28 M220 S80"}, {"G91 M220 S50"}) == Lines{"M220 S80"});
}

TEST_CASE("accelerations and pressure advance go back to what start G-code says") {
  CHECK(again({"M204 P800", "M204 T1500"}, {"M204 S300"}) == Lines{"M204 P800 T1500"});
  CHECK(again({"M204 P800 T1500", "M204 S900"}, {"M204 T300"}) == Lines{"M204 S900"});
  CHECK(again({"M204 S900", "M204 P800", "M204 T1500"}, {"M204 S300"}) == Lines{"M204 P800 T1500"});
  CHECK(again({"M204 S900 R700"}, {"M204 R300"}) == Lines{"M204 R700"});
  CHECK(again({"SET_VELOCITY_LIMIT VELOCITY=200 ACCEL=4000"}, {"M204 S300"}) ==
        Lines{"SET_VELOCITY_LIMIT ACCEL=4000"});
  CHECK(again({"M204 S900"}, {"set_velocity_limit accel=300"}) == Lines{"M204 S900"});
  CHECK(again({"M900 K0.2"}, {"M900 K0"}) == Lines{"M900 K0.2"});
  CHECK(again({"M572 D0 S0.05", "M572 D1 S0.07"}, {"M572 D1 S0"}) == Lines{"M572 D1 S0.07"});
  CHECK(again({"SET_PRESSURE_ADVANCE ADVANCE=0.05"},
              {"SET_PRESSURE_ADVANCE EXTRUDER=extruder ADVANCE=0"}) ==
        Lines{"SET_PRESSURE_ADVANCE ADVANCE=0.05"});
  CHECK(again({"SET_VELOCITY_LIMIT ACCEL=4000"}, {"SET_VELOCITY_LIMIT VELOCITY=50"}).empty());
}

TEST_CASE("what nobody knows is lost, and said so; what the settings tell is not") {
  CHECK(again({}, {"M204 S300", "M900 K0"}).empty());
  CHECK(loses({}, {"M204 S300"}));
  CHECK(loses({}, {"M900 K0"}));
  CHECK(loses({"M900 K0.2"}, {"M900 K0.1 T1"}));
  CHECK_FALSE(loses({"M900 K0.2", "M204 S500"}, {"M204 S300", "M900 K0"}));
  CHECK_FALSE(loses({}, {"M220 S50", "M221 S50", "T1", "M600"}));
  core::Settings settings = started({"M900 K0.2", "M204 S500"});
  settings.default_acceleration_mm_s2 = 1'000;
  settings.pressure_advance_s = 0;
  const host::StandingValues told(settings);
  CHECK(told.told_again_after({"M204 S300", "M900 K0.1"}).empty());
  CHECK_FALSE(told.loses_value({"M204 S300", "M900 K0.1"}));
}

TEST_CASE("what stands is told by its number") {
  const host::StandingValues none(started({"G28"}));
  CHECK_EQ(none.tool(), "");
  CHECK_EQ(none.feed(), 100);
  CHECK_EQ(none.flow(), 100);
  const host::StandingValues some(started({"T1", "M220 S80", "M221 S95", "M220 S70"}));
  CHECK_EQ(some.tool(), "T1");
  CHECK_EQ(some.feed(), 70);
  CHECK_EQ(some.flow(), 95);
}
