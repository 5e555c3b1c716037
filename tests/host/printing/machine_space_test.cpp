// A bed that is larger than the machine: parking stays within what the controller tells, and a part
// beyond it never heats anything.
#include "host/printing/machine_space.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "host/system/exit_codes.h"
#include "tests/host/print_rig.h"

using core::Length;
using print_test::Rig;

namespace {

core::Settings with_bed(double side_mm) {
  core::Settings settings;
  settings.layer_height = Length::from_mm(0.3);
  settings.wall_thickness = Length::from_mm(0.6);
  settings.bed_x = settings.bed_y = Length::from_mm(side_mm);
  settings.centre = false;  // so that the farthest corner is on the right
  settings.part_x = settings.part_y = Length::from_mm(20);
  return settings;
}

// Printed with the default bed of 300 mm, on a machine of that size.
struct Outcome {
  int exit_code = 0;
  std::string message;
  double x_mm_max = 0;
  std::int64_t clamped_moves = 0;
};

Outcome printed_on(double side_mm, double part_mm, bool tells, double park_x_mm = -1) {
  const test::PartFolder folder;
  const std::string part = folder.add("part.stl", parts::box({0, 0, 0}, part_mm, part_mm, 0.9));
  firmware_link::VirtualControllerOptions controller;
  controller.tells_travel = tells;
  core::Settings machine = with_bed(side_mm), asked = with_bed(300);
  machine.park_x = asked.park_x = Length::from_mm(park_x_mm);
  Rig rig(machine, print_test::open(asked, part), controller);
  bool paused = false;
  rig.control.request = [&]() -> std::optional<host::UserRequest> {
    if (paused || rig.executed.size() < 60) return std::nullopt;
    paused = true;
    return host::UserRequest::kPause;
  };
  rig.options.banner_wait_s = 0.05;
  Outcome outcome;
  rig.wire->on_read = [&] {
    outcome.x_mm_max = std::max(outcome.x_mm_max, rig.controller().x_mm);
    if (rig.controller().z_mm > 9) rig.control.stop = [] { return 1; };
  };
  const host::PrintOutcome end = rig.print();
  outcome.exit_code = end.exit_code;
  outcome.message = end.message;
  outcome.clamped_moves = rig.port->controller().totals().clamped_moves;
  if (!paused) CHECK_EQ(rig.count("M104"), 0);
  return outcome;
}

}  // namespace

TEST_CASE("parking stays within what the controller tells") {
  const Outcome told = printed_on(200, 20, true);
  CAPTURE(told.message);
  CHECK_EQ(told.exit_code, host::kExitStopped);
  CHECK_EQ(told.x_mm_max, 195);
  CHECK_EQ(told.clamped_moves, 0);
  // Without a word from the controller only its end stops hold it.
  const Outcome silent = printed_on(200, 20, false);
  CAPTURE(silent.message);
  CHECK_GT(silent.clamped_moves, 0);
}

TEST_CASE("a part beyond the controller's axes is refused before anything heats") {
  const Outcome refused = printed_on(200, 190, true);
  CAPTURE(refused.message);
  CHECK_EQ(refused.exit_code, host::kExitBadInput);
  CHECK_NE(refused.message.find("200"), std::string::npos);
  CHECK_EQ(refused.x_mm_max, 0);
}

TEST_CASE("a parking place beyond the controller's axes is refused before anything heats") {
  CHECK_EQ(printed_on(200, 20, true, 200).exit_code, host::kExitStopped);
  const Outcome refused = printed_on(200, 20, true, 210);
  CAPTURE(refused.message);
  CHECK_EQ(refused.exit_code, host::kExitBadInput);
  CHECK_NE(refused.message.find("park_x"), std::string::npos);
  CHECK_EQ(refused.x_mm_max, 0);
}

TEST_CASE("what is said of a bed, and what fits") {
  const host::MachineSpace guess{Length::from_mm(300), Length::from_mm(300), {}, true};
  host::MachineSpace known = guess;
  known.guessed = false;
  const firmware_link::TravelLimits limits{{0, 0, 0}, {200, 210, 180}};
  CHECK_NE(host::space_note(guess, std::nullopt), "");
  CHECK_EQ(host::space_note(known, std::nullopt), "");
  CHECK_NE(host::space_note(known, limits), "");
  CHECK_EQ(host::space_note({Length::from_mm(200), Length::from_mm(200), {}, false}, limits), "");
  const host::MachineSpace both = host::within(known, limits);
  CHECK_EQ(both.bed_x.mm(), 200);
  CHECK_EQ(both.bed_y.mm(), 210);
  CHECK_EQ(both.axis_z.mm(), 180);
  const core::Box part{{100'000, 100'000}, {2'000'000, 2'100'000}};
  CHECK(host::check_travel(part, Length::from_mm(180), limits).ok());
  CHECK_FALSE(host::check_travel(part, Length::from_mm(181), limits).ok());
  const core::Box wide{{100'000, 100'000}, {2'001'000, 2'100'000}};
  CHECK_FALSE(host::check_travel(wide, Length::from_mm(18), limits).ok());
  firmware_link::Move move;
  move.x_um = 200'000;
  CHECK(host::within_travel(move, limits));
  move.z_um = 180'020;
  CHECK_FALSE(host::within_travel(move, limits));
}
