#include "host/printing/command_history.h"

#include <doctest/doctest.h>

#include <memory>
#include <vector>

#include "tests/host/machine_samples.h"

using print_test::in_a_road;

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
  for (int i = 1; i <= 10; ++i) {  // even together too short to be sure of a block
    move.x_um = 9'000 + i * 19;
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

TEST_CASE("many short moves make a block together, and a file's lines count as moves") {
  host::CommandHistory history;
  history.start_at(0, in_a_road(), {std::make_shared<host::Checkpoint>(), 7});
  host::QueuedCommand queued;
  for (int i = 1; i <= 300; ++i) {
    firmware_link::ReadyLine line;
    line.move.x_um = *in_a_road().x_um + i * 90;  // three of them are longer than a block's least
    queued.command = line;
    history.push(queued);
  }
  const auto executed = history.executed_before(300, firmware_link::kPlannerBlocks);
  REQUIRE(executed.has_value());
  CHECK_GE(*executed, 300 - 3 * 16 - 3);
  CHECK_LE(*executed, 300 - 3 * 16 + 3);
}

TEST_CASE("no time is gone back behind a command that waits for all moves") {
  host::CommandHistory history;
  history.start_at(0, in_a_road(), {std::make_shared<host::Checkpoint>(), 7});
  host::QueuedCommand queued;
  firmware_link::Move move;
  for (int i = 0; i < 8; ++i) {
    move.x_um = i * 1'000;
    queued.command = move;
    if (i == 4) {
      queued.command = std::get<firmware_link::Verbatim>(firmware_link::verbatim_from("M400"));
    }
    queued.seconds = i;
    history.push(queued);
  }
  CHECK_EQ(history.executed_before(8, 1.5), 6);
  CHECK_EQ(history.executed_before(8, 5.5), 5);
}
