// From a PrusaSlicer profile, or start G-code, to what a machine lays: by its own reading of the
// G-code, and printed.
#include "tests/host/profile_print.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>

#include "core/bed.h"
#include "host/system/exit_codes.h"

using namespace profile_test;

TEST_CASE("whatever modes the start G-code leaves, the part is the same") {
  const Asked asked;
  Settings settings = asked.good({});
  const GcodeMachine right = asked.made(settings);
  CHECK_GT(right.filament_mm, 50);
  CHECK_EQ(right.x_min + right.x_max, doctest::Approx(250));
  CHECK_EQ(right.z_max, doctest::Approx(2.1));  // 0.3 and 9 times 0.2
  for (const char* start :
       {"", "G28\nM82", "G28\nM82\nG92 E0\nG1 Z5 F5000", "G20\nG28", "G28\nG20\nG1 X2 F100",
        "G28\nG91\nG1 Z10 F600", "G28\nG91\nM82\nG1 X50 Y20 E5", "G91", "G28\nG18", "G28\nG19",
        "G28\nM200 D1.75", "g28\ng91\ng20", "G28\nG1 X100 E20 F1000\nG1 X200 E30\nG92 E0",
        "G28\nG1 Z0.2\nG1 X60 E9 F1000", "G20\nG91\nM83\nG18\nM200 D1.75\nG1 X1 E1",
        "G28 ; home\nG91 ; relative\nG1 Z5 ; up"}) {
    CAPTURE(start);
    settings.start_gcode = lines_of(start);
    const GcodeMachine machine = asked.made(settings);
    CHECK_EQ(machine.filament_mm, doctest::Approx(right.filament_mm).epsilon(1e-6));
    CHECK_EQ(machine.x_min, doctest::Approx(right.x_min));
    CHECK_EQ(machine.x_max, doctest::Approx(right.x_max));
    CHECK_EQ(machine.y_min, doctest::Approx(right.y_min));
    CHECK_EQ(machine.y_max, doctest::Approx(right.y_max));
    CHECK_EQ(machine.z_max, doctest::Approx(right.z_max));
    CHECK_EQ(machine.wrong_plane_arcs, 0);
  }
  // Who gives the place another name wants the part there.
  settings.start_gcode = {"G28", "G92 X-10 Y5 Z-0.1"};
  const GcodeMachine moved = asked.made(settings);
  CHECK_EQ(moved.filament_mm, doctest::Approx(right.filament_mm).epsilon(1e-6));
  CHECK_EQ(moved.x_min, doctest::Approx(right.x_min + 10));
  CHECK_EQ(moved.y_max, doctest::Approx(right.y_max - 5));
  CHECK_EQ(moved.z_max, doctest::Approx(right.z_max + 0.1));
}

TEST_CASE("a print with such a start is the file, and the controller agrees") {
  const Asked asked;
  for (const char* start :
       {"G28\nM82\nG92 E0\nG1 Z5 F5000", "G28\nG91\nG1 Z10 F600", "", "G28\nG92 X10 Y10\nG1 X20"}) {
    CAPTURE(start);
    Settings settings = asked.good({});
    settings.start_gcode = lines_of(start);
    settings.axis_z = Length();
    Rig rig(settings, asked.part);
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    CHECK_EQ(rig.port->controller().totals().unknown_commands, 0);
    Lines sliced = print_test::sliced_lines(settings, asked.part);
    CHECK_EQ(std::count(sliced.begin(), sliced.end(), "G92 E0"),
             std::string(start).find("G92 E0") != std::string::npos ? 2 : 1);
    // The session has its own G92 E0: those are left out on both sides.
    sliced = print_test::given_lines(settings, asked.part);
    const auto first = std::find(rig.executed.begin(), rig.executed.end(), sliced.front());
    CHECK(Lines(first, rig.executed.end()) == sliced);
  }
}

TEST_CASE("profile: cooling off, 5 % more filament, a hot bed") {
  const Asked asked;
  const std::map<std::string, std::string> abs = {{"cooling", "0"},
                                                  {"fan_always_on", "0"},
                                                  {"bridge_fan_speed", "0"},
                                                  {"bed_temperature", "100"},
                                                  {"temperature", "245"}};
  const Settings settings = asked.good(abs);
  const GcodeMachine machine = asked.made(settings);
  CHECK_EQ(machine.fan_most, 0);
  CHECK_EQ(machine.bed_celsius, 100);
  CHECK_EQ(machine.nozzle_celsius, 245);
  Settings plain = settings;
  plain.extrusion_multiplier = 1;
  CHECK_EQ(machine.filament_mm, doctest::Approx(1.05 * asked.made(plain).filament_mm));
  CHECK_EQ(settings.first_layer_height, core::Length::from_mm(0.3));
  CHECK_EQ(settings.first_layer_width, core::Length::from_mm(0.42));
  CHECK_EQ(settings.bed_first_layer_celsius, 65);
  CHECK_EQ(settings.brim_width, core::Length::from_mm(5));
  CHECK_EQ(settings.elephant_foot_compensation, core::Length::from_mm(0.2));
  const core::Result<host::WholeSettings> whole = asked.settings(abs);
  for (const char* named : {"hilbertcurve", "top_solid_layers = 5", "are taken, "}) {
    CAPTURE(named);
    CHECK(names(whole.value().notes, named));
  }
  CHECK_FALSE(names(whole.value().notes, "support_material"));
  CHECK_FALSE(names(whole.value().notes, "raft_layers"));
}

TEST_CASE("profile: the fan as PrusaSlicer has it") {
  const Asked asked;
  const auto fan = [&](std::map<std::string, std::string> changed) {
    changed.emplace("bridge_fan_speed", "0");
    return asked.made(asked.good(changed)).fan_most;
  };
  // Layers of a few seconds, slowed down.
  CHECK_EQ(fan({}), 255);
  CHECK_EQ(fan({{"max_fan_speed", "60"}}), 153);
  CHECK_EQ(fan({{"cooling", "0"}}), 89);
  CHECK_EQ(fan({{"cooling", "0"}, {"bridge_fan_speed", "80"}}), 204);
  CHECK_EQ(fan({{"cooling", "0"}, {"min_fan_speed", "20"}}), 51);
  CHECK_EQ(fan({{"cooling", "0"}, {"fan_always_on", "0"}}), 0);
  CHECK_EQ(fan({{"slowdown_below_layer_time", "0"}, {"fan_below_layer_time", "0"}}), 89);
  CHECK_EQ(fan({{"slowdown_below_layer_time", "0"},
                {"fan_below_layer_time", "0"},
                {"fan_always_on", "0"}}),
           0);
  CHECK_EQ(fan({{"disable_fan_first_layers", "10"}}), 0);
  CHECK_EQ(fan({{"disable_fan_first_layers", "9"}}), 255);
}

TEST_CASE("profile: a bed whose origin is in its middle") {
  const Asked asked;
  const Settings settings = asked.good({{"bed_shape", "-125x-105,125x-105,125x105,-125x105"}});
  CHECK_EQ(settings.bed_x.mm(), 250);
  CHECK_EQ(settings.bed_y.mm(), 210);
  const GcodeMachine machine = asked.made(settings);
  CHECK_EQ(machine.x_min, doctest::Approx(-machine.x_max));
  CHECK_EQ(machine.y_min, doctest::Approx(-machine.y_max));
  CHECK_LT(machine.x_max, 20);
  const core::Box part{{1'200'000, 1'000'000}, {1'300'000, 1'100'000}};
  const host::ParkingPosition place = host::parking_position(settings, part);
  CHECK_EQ(std::abs(place.x_um), 120'000);
  CHECK_EQ(std::abs(place.y_um), 100'000);
  // On the machine, too: no move is clamped.
  Rig rig(settings, asked.part);
  CHECK_EQ(rig.print().exit_code, host::kExitDone);
  CHECK_EQ(rig.port->controller().totals().clamped_moves, 0);
}

TEST_CASE("profile: a bed of another shape") {
  const Asked asked;
  const std::map<std::string, std::string> delta = {
      {"bed_shape", "-90x0,-45x-77.9,45x-77.9,90x0,45x77.9,-45x77.9"}};
  const Settings settings = asked.good(delta);
  CHECK_EQ(settings.bed_x.mm(), 180);
  CHECK_EQ(settings.bed_shape.size(), 6);
  const GcodeMachine machine = asked.made(settings);
  CHECK_EQ(machine.x_min, doctest::Approx(-machine.x_max));
  CHECK_EQ(machine.y_min, doctest::Approx(-machine.y_max));
  // All of the print stays on it, parking too.
  const core::Bed bed(settings);
  for (const core::Point corner : {core::Point{0, 0}, core::Point{1'700'000, 1'500'000}}) {
    const host::ParkingPosition place = host::parking_position(settings, {corner, corner});
    CHECK(bed.holds(core::Point{static_cast<std::int32_t>(place.x_um * 10 + 900'000),
                                static_cast<std::int32_t>(place.y_um * 10 + 779'000)}));
  }
  // What can't be read is refused.
  const std::map<std::string, std::string> crossed = {{"bed_shape", "0x0,5x5,5x0,0x5"}};
  CHECK(contains(asked.refusal(crossed), "profile.ini:2: bed_shape: the outline crosses"));
  CHECK(contains(asked.refusal(crossed), "--profile-lax"));
  CHECK_EQ(asked.good(crossed, true).bed_x, Settings().bed_x);
  CHECK(names(asked.settings(crossed, true).value().notes, "the outline crosses"));
  // Who says where to print does without the profile's bed.
  const std::string path = asked.folder.file("profile.ini");
  for (const auto& [key, value] :
       {std::pair("bed_x", "100"), std::pair("bed_shape", "rectangle")}) {
    const auto whole = host::whole_settings(
        {path, false, {{key, value}, {"bed-y", "100"}, {"bed_origin_x", "-50"}}});
    REQUIRE(whole.ok());
    CHECK_EQ(whole.value().settings.bed_y.mm(), 100);
  }
}
