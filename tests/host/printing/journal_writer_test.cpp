#include "host/printing/journal_writer.h"

#include <doctest/doctest.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "host/printing/command_history.h"
#include "tests/host/machine_samples.h"
#include "tests/host/scripted_control.h"
#include "tests/support/temporary_folder.h"

using host::JournalRecord;
using host::LinkAccount;
using host::PrintState;

namespace {

// A print in its first layer: 10 mm a command, each a road.
struct Bench {
  host::CommandQueue queue{{1'000, 10'000'000}};
  host::PrintCommands commands{queue};
  host::PauseControl pauses{host::ParkMoves(core::Settings(), {0, 0}), 600};
  std::atomic<core::LayerIndex> layers = 7;
  print_test::ScriptedControl control;
  host::Reporter reporter{{.quiet = true, .json = false, .stdout_taken = false}};
  host::JournalWriter writer{commands, pauses, layers, control, reporter};

  void give(int count) {
    const auto checkpoint = std::make_shared<host::Checkpoint>();
    for (int i = 0; i < count; ++i) {
      host::QueuedCommand queued;
      firmware_link::Move move;
      move.x_um = (commands.next() + 1) * 10'000;
      if (commands.next() == 0) move.y_um = move.z_um = 300;
      queued.command = move;
      queued.lays_road = true;
      queued.checkpoint = checkpoint;
      queued.hash = static_cast<std::uint64_t>(commands.next() + 1);
      queued.seconds = 0.5 * static_cast<double>(commands.next() + 1);
      REQUIRE(queue.push(queued, sizeof queued));
      commands.take();
    }
  }
};

LinkAccount account(std::int64_t accepted) {
  LinkAccount account;
  account.accepted = accepted;
  account.line = static_cast<std::int32_t>(accepted) + 20;
  account.lines_more = 2;
  account.line_kinds = 0b10;
  account.planner_blocks = 16;
  return account;
}

}  // namespace

TEST_CASE("a record holds what is sure, what was accepted, and the lines in flight") {
  Bench bench;
  CHECK_FALSE(bench.writer.record(PrintState::kRunning, account(0)).has_value());  // no road yet
  bench.give(40);
  const std::optional<JournalRecord> record =
      bench.writer.record(PrintState::kRunning, account(38));
  REQUIRE(record.has_value());
  CHECK_EQ(record->sure, 38 - 16);
  CHECK_EQ(record->sure_hash, 22);
  CHECK_EQ(record->accepted, 38);
  CHECK_EQ(record->machine.x_um, 380'000);
  CHECK_EQ(record->nozzle_z_um, 300);
  CHECK_EQ(record->line, 58);
  CHECK_EQ(record->lines_more, 2);
  CHECK_EQ(record->line_kinds, 0b10);
  CHECK_EQ(record->layers, 7);
  CHECK(record->state == PrintState::kRunning);
}

TEST_CASE("a planner that counts in time holds the last seconds; one that is empty holds nothing") {
  Bench bench;
  bench.give(40);
  LinkAccount by_time = account(40);
  by_time.planned_s = 2.4;
  CHECK_EQ(bench.writer.record(PrintState::kRunning, by_time)->sure, 40 - 5);
  bench.writer.note_all_moved();
  CHECK_EQ(bench.writer.record(PrintState::kStopped, account(40))->sure, 40);
}

TEST_CASE("after a reset nothing is sure but what was before, until the way back is accepted") {
  Bench bench;
  bench.give(40);
  bench.commands.resume(20, 20);
  bench.writer.start_session(10, false);
  const auto waiting = bench.writer.record(PrintState::kRunning, account(0));
  REQUIRE(waiting.has_value());
  CHECK_EQ(waiting->sure, 10);
  CHECK_EQ(waiting->accepted, 20);
  CHECK_EQ(waiting->lines_more, 0);
  CHECK_GT(waiting->line, 1'000'000);  // no line of the controller's
  const auto resumed = bench.writer.record(PrintState::kRunning, account(1));
  REQUIRE(resumed.has_value());
  CHECK_EQ(resumed->sure, 20);
  CHECK_EQ(resumed->line, 21);
}

TEST_CASE("the journal is kept from the first road on, but not while it is suspended") {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("print.journal");
  host::JournalHead head;
  head.version = "test";
  core::Result<host::Journal> journal = host::Journal::create(path, head);
  REQUIRE(journal.ok());
  Bench bench;
  CHECK_FALSE(bench.writer.keeps());  // there is none
  bench.control.kept_journal = &journal.value();
  CHECK_FALSE(bench.writer.keeps());  // no road
  bench.give(40);
  CHECK(bench.writer.keeps());
  bench.writer.suspend(true);
  bench.writer.keep(account(30));
  bench.writer.close(PrintState::kStopped, account(30), core::Settings());
  CHECK_FALSE(host::read_journal(path).ok());
  bench.writer.suspend(false);
  bench.writer.keep(account(30));
  REQUIRE(host::read_journal(path).ok());
  CHECK_EQ(host::read_journal(path).value().record.accepted, 30);

  // A safe stop has lifted the nozzle.
  bench.writer.close(PrintState::kStopped, account(40), core::Settings());
  const JournalRecord last = host::read_journal(path).value().record;
  CHECK_EQ(last.accepted, 40);
  CHECK(last.state == PrintState::kStopped);
  CHECK_EQ(last.nozzle_z_um, 10'300);

  // A new session's lines mean something else.
  bench.writer.renumber(last, 38, 5'000);
  const JournalRecord renumbered = host::read_journal(path).value().record;
  CHECK_EQ(renumbered.accepted, 38);
  CHECK_EQ(renumbered.lines_more, 0);
  CHECK_EQ(renumbered.nozzle_z_um, 5'000);
  bench.writer.remove();
  CHECK_FALSE(host::read_journal(path).ok());
}
