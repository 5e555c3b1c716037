#include "host/printing/park_moves.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host/printing/safe_moves.h"
#include "tests/host/machine_samples.h"

using core::Length;
using firmware_link::Command;
using print_test::in_a_road;
using print_test::texts_of;

namespace {

using Texts = std::vector<std::string>;

core::Box box_at(double x, double y, double side) {
  const auto units = [](double mm) {
    return static_cast<std::int32_t>(Length::from_mm(mm).units());
  };
  core::Box box;
  box.add(core::Point{units(x), units(y)});
  box.add(core::Point{units(x + side), units(y + side)});
  return box;
}

}  // namespace

TEST_CASE("the nozzle leaves drawn back and lifted, and comes back primed") {
  const core::Settings settings;
  const host::ParkMoves park_moves(settings, {5'000, 295'000});
  const host::MachineState here = in_a_road();
  CHECK(texts_of(park_moves.leave_part(here)) ==
        Texts{"G1 E-1 F2400", "G0 Z12.4 F600", "G0 X5 Y295 F7800"});
  CHECK(texts_of(park_moves.come_back(here, false)) ==
        Texts{"G1 E1 F2400", "G1 E4 F240", "G1 E-1 F2400", "G0 X50 Y60.5 F7800", "G0 Z2.4 F600",
              "G1 E1 F2400", "M106 S255", "G0 F3600"});
  CHECK(texts_of(park_moves.come_back(here, true)).front() == "M140 S60");
  CHECK(texts_of(park_moves.come_back(here, true))[1] == "M109 S210");
}

TEST_CASE("the nozzle leaves over what stands beside it, finished") {
  const core::Settings settings;
  const host::ParkMoves park_moves(settings, {5'000, 295'000});
  host::MachineState here = in_a_road();
  here.highest_laid_um = 40'000;
  CHECK(texts_of(park_moves.leave_part(here))[1] == "G0 Z50 F600");
  const Texts restart = texts_of(park_moves.restart(here, 2'400, ""));
  CHECK(std::find(restart.begin(), restart.end(), "G0 Z50 F600") != restart.end());
  // In coordinates that a file has moved, heights from before say nothing.
  here.shifted = true;
  CHECK_EQ(host::lifted_from_um(here), 2'400);
}

TEST_CASE("filament that is drawn back already stays as it was") {
  const core::Settings settings;
  const host::ParkMoves park_moves(settings, {0, 0});
  host::MachineState here = in_a_road();
  here.drawn_back_10nm = 100'000;
  CHECK(texts_of(park_moves.leave_part(here)).front() == "G0 Z12.4 F600");
  host::MachineState after = here;
  for (const Command& command : park_moves.leave_part(here)) after.apply(command);
  for (const Command& command : park_moves.come_back(here, false)) after.apply(command);
  CHECK_EQ(after.drawn_back_10nm, here.drawn_back_10nm);
  CHECK_EQ(after.x_um, here.x_um);
  CHECK_EQ(after.z_um, here.z_um);
  CHECK_EQ(after.f_mm_min, here.f_mm_min);
}

TEST_CASE("after a reset X and Y are homed, hot and lifted, and Z never") {
  core::Settings settings;
  settings.start_gcode = {"G21", "G28", "M420 S1", "M104 S200", "M92 E400 ; steps", "G1 X5 E9"};
  const host::ParkMoves park_moves(settings, {5'000, 5'000});
  const Texts way = texts_of(park_moves.restart(in_a_road(), 2'400, "G92 Z"));
  CHECK(way == Texts{"G21", "G90", "M83", "M420 S1", "M92 E400", "G92 Z2.400", "M104 S210",
                     "M190 S60", "M109 S210", "G1 E-1 F2400", "G0 Z12.4 F600", "G28 X Y",
                     "G0 X5 Y5 F7800"});
  // Lifted from where the nozzle is, not from where it should be.
  const Texts higher =
      texts_of(park_moves.restart(in_a_road(), 30'000, "SET_KINEMATIC_POSITION Z="));
  CHECK_EQ(higher[5], "SET_KINEMATIC_POSITION Z=30.000");
  CHECK_EQ(higher[10], "G0 Z40 F600");
  settings.axis_z = Length::from_mm(5);
  CHECK_EQ(host::lifted_um(2'400, settings), 5'000);
  CHECK_EQ(host::lifted_um(6'000, settings), 6'000);
}

TEST_CASE("after a reset the tool is chosen that start G-code chose, before anything heats") {
  core::Settings settings;
  settings.start_gcode = {"G28", "T1", "M221 S95", "M109 S200"};
  const host::ParkMoves park_moves(settings, {5'000, 5'000});
  host::MachineState here = in_a_road();
  const Texts way = texts_of(park_moves.restart(here, 2'400, "G92 Z"));
  CHECK(Texts(way.begin() + 3, way.begin() + 5) == Texts{"T1", "M221 S95"});
  // Macros for the tool would move axes that are not homed.
  here.flavor = firmware_link::Flavor::kRepRapFirmware;
  CHECK_EQ(texts_of(park_moves.restart(here, 2'400, "G92 Z"))[3], "T1 P0");
}

TEST_CASE("the parking position is the bed's corner farthest from the part") {
  core::Settings settings;
  settings.bed_x = settings.bed_y = Length::from_mm(200);
  const auto position = [&](double x, double y) {
    const host::ParkingPosition at = host::parking_position(settings, box_at(x, y, 50));
    return std::vector<std::int64_t>{at.x_um, at.y_um};
  };
  CHECK(position(0, 0) == std::vector<std::int64_t>{195'000, 195'000});
  CHECK(position(140, 10) == std::vector<std::int64_t>{5'000, 195'000});
  CHECK(position(140, 140) == std::vector<std::int64_t>{5'000, 5'000});
  CHECK_EQ(host::parking_position(settings, {}).x_um, 5'000);
  // Where the user says; only x is said here.
  settings.park_x = Length::from_mm(100);
  CHECK(position(0, 0) == std::vector<std::int64_t>{100'000, 195'000});
}
