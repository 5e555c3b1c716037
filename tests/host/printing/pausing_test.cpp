// The ways off the part and back, when they are gone, and where a print goes on.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "firmware_link/wire/line_codec.h"
#include "host/printing/command_history.h"
#include "host/printing/controls.h"
#include "host/printing/feed_throttle.h"
#include "host/printing/park_moves.h"
#include "host/printing/pause_control.h"
#include "host/printing/resume_point.h"
#include "host/printing/safe_moves.h"

using core::Length;
using firmware_link::Command;
using host::PauseControl;

namespace {

std::vector<std::string> texts_of(const std::vector<Command>& commands) {
  std::vector<std::string> texts;
  for (const Command& command : commands) {
    firmware_link::TextBuffer buffer;
    texts.emplace_back(firmware_link::encode(command, buffer));
  }
  return texts;
}

host::MachineState in_a_road() {
  host::MachineState state;
  state.x_um = 50'000;
  state.y_um = 60'500;
  state.z_um = 2'400;
  state.f_mm_min = 3'600;
  state.nozzle_tenths = 2'100;
  state.bed_tenths = 600;
  state.fan = 255;
  return state;
}

core::Box box_at(double x, double y, double side) {
  const auto units = [](double mm) {
    return static_cast<std::int32_t>(Length::from_mm(mm).units());
  };
  core::Box box;
  box.add(core::Point{units(x), units(y)});
  box.add(core::Point{units(x + side), units(y + side)});
  return box;
}

using Texts = std::vector<std::string>;

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

TEST_CASE("the parking place is the bed's corner farthest from the part") {
  core::Settings settings;
  settings.bed_x = settings.bed_y = Length::from_mm(200);
  const auto place = [&](double x, double y) {
    const host::ParkingPosition at = host::parking_position(settings, box_at(x, y, 50));
    return std::vector<std::int64_t>{at.x_um, at.y_um};
  };
  CHECK(place(0, 0) == std::vector<std::int64_t>{195'000, 195'000});
  CHECK(place(140, 10) == std::vector<std::int64_t>{5'000, 195'000});
  CHECK(place(140, 140) == std::vector<std::int64_t>{5'000, 5'000});
  CHECK_EQ(host::parking_position(settings, {}).x_um, 5'000);
}

TEST_CASE("a pause leaves, waits, lets the nozzle cool, and comes back when nobody wants it") {
  const core::Settings settings;
  const host::ParkMoves park_moves(settings, {5'000, 5'000});
  const host::MachineState here = in_a_road();
  PauseControl pauses(park_moves, 100);
  CHECK_FALSE(pauses.turn_due());
  const auto drain = [&pauses] {
    std::vector<Command> way;
    while (const auto command = pauses.next()) way.push_back(*command);
    return texts_of(way);
  };
  pauses.want_pause(true);
  pauses.set_underrun(true);
  REQUIRE(pauses.turn(0, here));
  CHECK(drain() == texts_of(park_moves.leave_part(here)));
  CHECK_EQ(pauses.nozzle_z_um(), 12'400);
  REQUIRE(pauses.turn(1, here));
  CHECK(pauses.phase() == PauseControl::Phase::kAway);
  pauses.want_pause(false);  // geometry still has nothing
  CHECK_FALSE(pauses.turn(2, here));
  CHECK(drain().empty());
  CHECK_FALSE(pauses.turn(101, here));
  CHECK(drain() == Texts{"M104 S0"});
  CHECK_FALSE(pauses.turn(300, here));
  CHECK(drain().empty());
  pauses.set_underrun(false);
  REQUIRE(pauses.turn(301, here));
  CHECK(drain() == texts_of(park_moves.come_back(here, true)));
  REQUIRE(pauses.turn(302, here));
  CHECK(pauses.printing());
  CHECK_FALSE(pauses.nozzle_z_um().has_value());
}

TEST_CASE("before the first road a pause only waits") {
  const host::ParkMoves park_moves(core::Settings(), {5'000, 5'000});
  PauseControl pauses(park_moves, 100);
  pauses.want_pause(true);
  CHECK(pauses.turn(0, {}));
  CHECK_FALSE(pauses.next().has_value());
  CHECK(pauses.turn(0, {}));
  pauses.want_pause(false);
  CHECK(pauses.turn(1, {}));
  CHECK_FALSE(pauses.next().has_value());
  CHECK(pauses.turn(1, {}));
  CHECK(pauses.printing());
}

TEST_CASE("the feed sinks with what is ahead, and rises by steps") {
  host::FeedThrottle throttle;
  CHECK_EQ(throttle.percent(0, 0.5, true), 100);  // the queue has not been filled yet
  CHECK_EQ(throttle.percent(1, 10, true), 100);
  CHECK_EQ(throttle.percent(2, 3, true), 75);
  CHECK_EQ(throttle.percent(2.5, 1, true), 75);  // not yet
  CHECK_EQ(throttle.percent(3.1, 2, true), 50);
  CHECK_EQ(throttle.percent(4.2, 0, true), host::FeedThrottle::kSlowest_percent);
  CHECK_EQ(throttle.percent(5.3, 9, true), 55);
  CHECK_EQ(throttle.percent(6.4, 9, true), 85);
  CHECK_EQ(throttle.percent(7.5, 9, true), 100);
  CHECK_EQ(throttle.percent(8.6, 0.1, false), 100);  // the end is no famine
}

TEST_CASE("where a print goes on") {
  using host::PrintState;
  host::JournalRecord record;
  record.sure = 90;
  record.accepted = 100;
  record.line = 130;
  record.lines_more = 4;
  record.line_kinds = 0b1011;  // the third is the link's own
  const auto at = [&](PrintState state, host::FoundController found) {
    record.state = state;
    return host::resume_point(record, found);
  };
  // The controller's own account, in any state.
  for (int state = 0; state < 5; ++state) {
    for (const auto& [line, command] : std::vector<std::pair<int, int>>{
             {130, 100}, {131, 101}, {132, 102}, {133, 102}, {134, 103}}) {
      const auto point = at(static_cast<PrintState>(state), {line, true, false});
      CHECK_EQ(point.command, command);
      CHECK(point.lives);
    }
  }
  for (const std::optional<std::int32_t> line :
       {std::optional<std::int32_t>(), std::optional<std::int32_t>(0),
        std::optional<std::int32_t>(129), std::optional<std::int32_t>(135)}) {
    // Whoever can't tell may have lost what its planner held.
    for (int state = 0; state < 5; ++state) {
      for (const bool same_boot : {false, true}) {
        const auto point = at(static_cast<PrintState>(state), {line, true, same_boot});
        CHECK_EQ(point.command, 90);
        CHECK_FALSE(point.lives);
      }
    }
  }
  // One that numbers nothing.
  CHECK_EQ(at(PrintState::kRunning, {{}, false, true}).command, 103);
  CHECK(at(PrintState::kRunning, {{}, false, true}).lives);
  CHECK_EQ(at(PrintState::kPortLost, {{}, false, true}).command, 103);
}

TEST_CASE("a history knows its last commands and the machine before each") {
  host::CommandHistory history;
  host::MachineState machine = in_a_road();
  history.start_at(1'000, machine, {});
  std::vector<host::MachineState> before;
  for (int i = 0; i < 600; ++i) {
    host::QueuedCommand queued;
    firmware_link::Move move;
    move.x_um = i * host::kBlockLengthUm;
    if (i % 3 == 0) move.f_mm_min = 600 + i;
    queued.command = move;
    if (i % 5 == 4) queued.command = firmware_link::SetFan{static_cast<std::uint8_t>(i % 256)};
    before.push_back(machine);
    machine.apply(queued.command);
    history.push(queued);
  }
  CHECK_EQ(history.end(), 1'600);
  CHECK_EQ(history.begin(), 1'600 - static_cast<std::int64_t>(host::kHistoryCommandsMax));
  for (std::int64_t i = history.begin(); i < history.end(); ++i) {
    CAPTURE(i);
    const host::MachineState& wanted = before[static_cast<std::size_t>(i - 1'000)];
    const host::MachineState state = history.state_before(i);
    CHECK_EQ(state.x_um, wanted.x_um);
    CHECK_EQ(state.f_mm_min, wanted.f_mm_min);
    CHECK_EQ(state.fan, wanted.fan);
  }
  // Numbers 1599 and 1594 blow, all others move.
  CHECK_EQ(history.executed_before(1'600, std::size_t{0}), 1'600);
  CHECK_EQ(history.executed_before(1'600, std::size_t{1}), 1'598);
  CHECK_EQ(history.executed_before(1'600, std::size_t{5}), 1'593);
  CHECK_EQ(history.executed_before(1'600, std::size_t{10'000}), std::nullopt);
}

TEST_CASE("short moves may have no block of their own, and some commands empty the planner") {
  host::CommandHistory history;
  history.start_at(0, in_a_road(), {std::make_shared<host::Checkpoint>(), 7});
  const auto push = [&history](const firmware_link::Command& command) {
    host::QueuedCommand queued;
    queued.command = command;
    history.push(queued);
  };
  const auto words = [](const char* line) {
    return std::get<firmware_link::Verbatim>(firmware_link::verbatim_from(line));
  };
  firmware_link::Move move;
  for (int i = 0; i < 10; ++i) {
    move.x_um = i * 1'000;
    push(move);
  }
  for (int i = 1; i <= 10; ++i) {  // all of them one block, or none
    move.x_um = 9'000 + i * 20;
    push(move);
  }
  CHECK_EQ(history.executed_before(20, std::size_t{2}), 8);
  push(words("M109 S200"));  // does not wait for moves
  CHECK_EQ(history.executed_before(21, std::size_t{2}), 8);
  push(words("M400"));
  CHECK_EQ(history.executed_before(22, std::size_t{16}), 22);
  move.x_um = 20'000;
  push(move);
  CHECK_EQ(history.executed_before(23, std::size_t{16}), 22);
  CHECK_EQ(history.executed_before(23, std::size_t{1}), 22);
  firmware_link::Move filament;
  filament.e_10nm = -100'000;
  push(filament);
  CHECK_EQ(history.executed_before(24, std::size_t{1}), 23);
  CHECK_EQ(history.mark_before(0).hash, 7);
}

TEST_CASE("keys") {
  CHECK(host::request_of_key('p') == host::UserRequest::kPause);
  CHECK(host::request_of_key('r') == host::UserRequest::kResume);
  CHECK(host::request_of_key('s') == host::UserRequest::kStop);
  CHECK(host::request_of_key('+') == host::UserRequest::kFeedUp);
  CHECK_FALSE(host::request_of_key('x').has_value());
}
