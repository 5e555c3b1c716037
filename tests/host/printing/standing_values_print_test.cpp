// What the user's lines leave of the tool, the factors, accelerations and pressure advance in the
// controller: behind lines at a height, after a reset, while rind slows a print down.
#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "host/printing/machine_state.h"
#include "host/system/exit_codes.h"
#include "tests/host/interrupted_print.h"

using firmware_link::VirtualControllerState;
using firmware_link::VirtualDialect;
using print_test::Rig;
using Lines = std::vector<std::string>;

namespace {

firmware_link::VirtualControllerOptions speaking(VirtualDialect dialect) {
  firmware_link::VirtualControllerOptions options;
  options.dialect = dialect;
  return options;
}

// The controller's state where roads are laid again behind "M117 last" at a height, and at the end.
struct Looks {
  VirtualControllerState behind, end;
};

Looks print(const core::Settings& settings, const std::string& path, VirtualDialect dialect) {
  Rig rig(settings, path, speaking(dialect));
  rig.options.banner_wait_s = 0.05;
  Looks looks;
  bool looked = false;
  rig.wire->on_read = [&] {
    if (looked) return;
    const auto last = std::find(rig.executed.begin(), rig.executed.end(), "M117 last");
    if (rig.executed.end() - last < 20) return;
    looked = true;
    looks.behind = rig.controller();
  };
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitDone);
  CHECK(looked);
  looks.end = rig.controller();
  return looks;
}

core::Settings with_lines(Lines start, const Lines& at_height) {
  core::Settings settings = print_test::coarse();
  settings.start_gcode = std::move(start);
  for (const std::string& line : at_height) settings.at_height.push_back("1.2 gcode " + line);
  return settings;
}

// Start G-code that sets all of it, and what a controller has then.
const Lines kSetUp = {"G28", "T1", "M220 S90", "M221 S95", "M204 P800 T1500", "M900 K0.2"};

void check_as_set_up(const VirtualControllerState& state) {
  CHECK_EQ(state.tool, 1);
  CHECK_EQ(state.feed_percent, 90);
  CHECK_EQ(state.flow_percent, 95);
  CHECK_EQ(state.limits.acceleration_mm_s2, 800);
  CHECK_EQ(state.limits.travel_acceleration_mm_s2, 1'500);
  CHECK_EQ(state.pressure_advance, doctest::Approx(0.2));
}

}  // namespace

TEST_CASE("behind lines at a height the controller is as start G-code set it up") {
  const test::PartFolder folder;
  const Lines lines = {"T0", "M220 S50", "M221 S120", "M204 S300", "M900 K0", "M117 last"};
  const core::Settings settings = with_lines(kSetUp, lines);
  const Looks looks = print(settings, print_test::small_part(folder), VirtualDialect::kMarlin);
  check_as_set_up(looks.behind);
  check_as_set_up(looks.end);
}

TEST_CASE("behind lines at a height the controller has what the settings told it") {
  const test::PartFolder folder;
  const std::string path = print_test::small_part(folder);
  for (const auto& [spoken, acceleration, advance] :
       {std::tuple(VirtualDialect::kMarlin, "M204 S300", "M900 K0"),
        std::tuple(VirtualDialect::kKlipper, "SET_VELOCITY_LIMIT ACCEL=300",
                   "SET_PRESSURE_ADVANCE ADVANCE=0"),
        std::tuple(VirtualDialect::kRepRap, "M204 P300 T300", "M572 D0 S0")}) {
    const VirtualDialect dialect = spoken;
    CAPTURE(static_cast<int>(dialect));
    core::Settings settings =
        with_lines({"G28"}, {"T1", "M220 S50", "M221 S120", acceleration, advance, "M117 last"});
    settings.default_acceleration_mm_s2 = 1'000;
    settings.pressure_advance_s = 0.045;
    const Looks looks = print(settings, path, dialect);
    for (const VirtualControllerState& state : {looks.behind, looks.end}) {
      CHECK_EQ(state.tool, 0);
      CHECK_EQ(state.feed_percent, 100);
      CHECK_EQ(state.flow_percent, 100);
      CHECK_EQ(state.limits.acceleration_mm_s2, 1'000);
      CHECK_EQ(state.pressure_advance, doctest::Approx(0.045));
    }
  }
}

TEST_CASE("after a reset a controller has them again") {
  const test::PartFolder folder;
  const core::Settings settings = with_lines(kSetUp, {});
  Rig rig(settings, print_test::small_part(folder));
  rig.options.lost_port_wait_s = 20;
  rig.control.height = [](std::int64_t z_um) { return z_um; };
  std::size_t before = 0;
  rig.wire->on_read = [&] {
    if (before > 0 || rig.executed.size() < 300) return;
    before = rig.executed.size();
    rig.port->controller().reset(rig.port->simulated_now());
  };
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitDone);
  REQUIRE_GT(before, 0);
  check_as_set_up(rig.controller());
}

TEST_CASE("the factors of the user's lines are known where a print is resumed") {
  core::Settings settings;
  settings.start_gcode = {"G28", "M220 S90", "M221 S95"};
  host::Checkpoint checkpoint;
  CHECK_EQ(host::state_at(checkpoint, settings).feed_percent, 100);  // not sent yet
  checkpoint.motions.started = true;
  host::MachineState state = host::state_at(checkpoint, settings);
  CHECK_EQ(state.feed_percent, 90);
  CHECK_EQ(state.flow_percent, 95);
  state.apply(host::command_of("M220 S50"));
  state.apply(host::command_of("M221 S120"));
  CHECK_EQ(state.feed_percent, 50);
  CHECK_EQ(state.flow_percent, 120);
}

TEST_CASE("what the user asks for while it prints comes on top of the lines' factors") {
  const test::PartFolder folder;
  const core::Settings settings =
      with_lines({"G28", "M220 S50", "M221 S80"}, {"M220 S70", "M221 S70", "M117 last"});
  Rig rig(settings, print_test::small_part(folder));
  int asked = 0;
  rig.control.request = [&]() -> std::optional<host::UserRequest> {
    if (rig.executed.size() < 50 || asked == 2) return std::nullopt;
    return ++asked == 1 ? host::UserRequest::kFeedUp : host::UserRequest::kFlowUp;
  };
  CHECK_EQ(rig.print().exit_code, host::kExitDone);
  REQUIRE_EQ(asked, 2);
  CHECK_EQ(rig.controller().feed_percent, 55);
  CHECK_EQ(rig.controller().flow_percent, 88);
}
