// Prints that are interrupted and resumed: paused, unplugged, reset, resumed from the journal. What
// is laid in all is what the whole print lays.
//
// RIND_MOMENTS=50 interrupts each kind at 50 random moments instead of the few that fit into every
// run.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "host/printing/journal.h"
#include "host/printing/park_moves.h"
#include "host/system/exit_codes.h"
#include "tests/host/interrupted_print.h"
#include "tests/support/temporary_folder.h"

using core::Length;
using host::UserRequest;
using print_test::coarse;
using print_test::laid_nothing_after;
using print_test::make_pluggable;
using print_test::new_journal;
using print_test::print_rest;
using print_test::Rig;
using print_test::small_part;
using test::laid_by;
using test::LaidPiece;
using test::PartFolder;

namespace {

int moments(int few) {
  const char* told = std::getenv("RIND_MOMENTS");
  return told != nullptr ? std::atoi(told) : few;
}

// Round beside it: arcs begin where the one before ended, wherever that was.
std::string round_part(const PartFolder& folder) {
  return folder.add("part.stl",
                    parts::together({parts::box({8, 8, 0}, 6, 5, 3), parts::tube(6, 4, 3, 180)}));
}

void check_same(const std::vector<LaidPiece>& laid, const std::vector<LaidPiece>& wanted) {
  REQUIRE_EQ(laid.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    CAPTURE(i);
    REQUIRE((laid[i] == wanted[i]));
  }
}

}  // namespace

TEST_CASE("a print that is paused lays the same roads, and the nozzle waits off the part") {
  const PartFolder folder;
  const std::string path = round_part(folder);
  const std::vector<LaidPiece> whole = laid_by(print_test::sliced_lines(coarse(), path));
  CHECK_GT(std::count_if(whole.begin(), whole.end(), [](const auto& at) { return at.turn != 0; }),
           50);
  std::mt19937 random(11);
  for (int i = 0; i < moments(6); ++i) {
    Rig rig(coarse(), path);
    const std::size_t at = 30 + random() % 400;
    const bool cools = i % 2 == 0;
    CAPTURE(at);
    rig.options.hot_s = cools ? 0 : 100;
    bool paused = false;
    bool away = false;
    bool gone_on = false;
    rig.control.request = [&]() -> std::optional<UserRequest> {
      if (!paused && rig.executed.size() >= at) {
        paused = true;
        return i == 5 ? UserRequest::kToggle : UserRequest::kPause;
      }
      if (!paused || gone_on) return std::nullopt;
      const auto state = rig.controller();
      away = away || (state.x_mm == 5 && state.y_mm == 5 && state.z_mm > 10);
      const bool cooled = !cools || state.nozzle_target_celsius == 0;
      if (!away || !cooled) return std::nullopt;
      CHECK_EQ(state.bed_target_celsius, 60);
      gone_on = true;
      return i == 5 ? UserRequest::kToggle : UserRequest::kResume;
    };
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    CHECK(gone_on);
    check_same(laid_by(rig.executed), whole);
    CHECK_EQ(rig.port->controller().totals().cold_extrusions, 0);
    CHECK_EQ(rig.count("G28"), 1);
  }
}

TEST_CASE("pause, resume and cancel at the printer are obeyed") {
  const PartFolder folder;
  const std::string path = small_part(folder);
  const std::vector<LaidPiece> whole = laid_by(print_test::sliced_lines(coarse(), path));
  for (const bool cancels : {false, true}) {
    CAPTURE(cancels);
    Rig rig(coarse(), path);
    int said = 0;
    rig.wire->on_read = [&] {
      if (said == 0 && rig.executed.size() > 100) {
        rig.wire->say("//action:pause\r\n");
        ++said;
      } else if (said == 1 && rig.controller().x_mm == 5 && rig.controller().z_mm > 10) {
        rig.wire->say(cancels ? "//action:cancel\n" : "// action:resume\n");
        ++said;
      }
    };
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(said, 2);
    CHECK_EQ(outcome.exit_code, cancels ? host::kExitStopped : host::kExitDone);
    if (!cancels) check_same(laid_by(rig.executed), whole);
    CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
  }
}

TEST_CASE("feed and flow go to the controller; a stop by key is a safe one") {
  const PartFolder folder;
  Rig rig(coarse(), small_part(folder));
  std::vector<UserRequest> requests = {UserRequest::kStop, UserRequest::kFlowDown,
                                       UserRequest::kFeedUp, UserRequest::kFeedUp};
  std::size_t next_at = 50;
  rig.control.request = [&]() -> std::optional<UserRequest> {
    if (requests.empty() || rig.executed.size() < next_at) return std::nullopt;
    const UserRequest request = requests.back();
    requests.pop_back();
    next_at = rig.executed.size() + 20;
    return request;
  };
  const host::PrintOutcome outcome = rig.print();
  CHECK_EQ(outcome.exit_code, host::kExitStopped);
  CHECK_EQ(rig.count("M220 S110"), 1);
  CHECK_EQ(rig.count("M220 S120"), 1);
  CHECK_EQ(rig.count("M221 S90"), 1);
  CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
  CHECK_GT(rig.controller().z_mm, 10);
}

TEST_CASE("a port that vanishes and comes back loses no road and doubles none") {
  const PartFolder folder;
  const std::string path = round_part(folder);
  const std::vector<LaidPiece> whole = laid_by(print_test::sliced_lines(coarse(), path));
  std::mt19937 random(12);
  for (int i = 0; i < moments(3); ++i) {
    Rig rig(coarse(), path);
    make_pluggable(rig, 20);
    const std::size_t at = 20 + random() % 450;
    CAPTURE(at);
    rig.wire->on_read = [&] {
      if (rig.executed.size() >= at) rig.wire->unplug();
    };
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    CHECK_EQ(outcome.link.recoveries, 1);
    check_same(laid_by(rig.executed), whole);
    CHECK_EQ(rig.count("G28"), 1);  // it was running: nothing was homed again
  }
}

TEST_CASE("after a controller's reset what its planner lost is laid once more") {
  const PartFolder folder;
  const std::string path = small_part(folder);
  const std::vector<LaidPiece> whole = laid_by(print_test::sliced_lines(coarse(), path));
  std::mt19937 random(13);
  for (int i = 0; i < moments(2); ++i) {
    firmware_link::VirtualControllerOptions options;
    options.advanced_ok = true;
    Rig rig(coarse(), path, options);
    rig.options.lost_port_wait_s = 20;
    std::int64_t asked_um = -1;
    rig.control.height = [&](std::int64_t z_um) { return asked_um = z_um; };
    const std::size_t at = 60 + random() % 400;
    CAPTURE(at);
    std::vector<std::string> before;
    std::size_t lost = 0;
    rig.wire->on_read = [&] {
      if (!before.empty() || rig.executed.size() < at) return;
      lost = rig.controller().planner_blocks;  // lets it do all it can
      before = rig.executed;
      rig.port->controller().reset(rig.port->simulated_now());
    };
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    CHECK_EQ(outcome.link.recoveries, 1);
    CHECK_GE(asked_um, 300);
    CHECK_EQ(rig.count("G28 X Y"), 1);
    CHECK_EQ(rig.count("G28"), 2);
    CHECK_EQ(rig.port->controller().totals().cold_extrusions, 0);

    std::vector<std::string> moved = before;
    for (std::size_t moves = lost; moves > 0 && !moved.empty(); moved.pop_back()) {
      const std::string& text = moved.back();
      moves -= text.compare(0, 2, "G0") == 0 || text.compare(0, 2, "G1") == 0 ? 1 : 0;
    }
    const std::size_t laid_before = laid_by(moved).size();
    const std::size_t taken_before = laid_by(before).size();
    const std::vector<LaidPiece> all = laid_by(rig.executed);
    REQUIRE_GE(all.size(), whole.size());
    const std::size_t again = all.size() - whole.size();  // of what had been taken
    CAPTURE(lost);
    REQUIRE_LE(again, taken_before);
    // Shorter ones may have no block of their own.
    const auto blocks = std::count_if(
        whole.begin() + static_cast<std::ptrdiff_t>(taken_before - again),
        whole.begin() + static_cast<std::ptrdiff_t>(taken_before), [](const LaidPiece& piece) {
          const double block_mm = static_cast<double>(host::kBlockLengthUm) * 1e-3;
          return piece.turn != 0 || std::abs(piece.to[0] - piece.from[0]) >= block_mm ||
                 std::abs(piece.to[1] - piece.from[1]) >= block_mm;
        });
    CHECK_LE(blocks, firmware_link::kPlannerBlocks + firmware_link::kWindowLinesMax);
    CHECK_LE(taken_before - again, laid_before);  // nothing that was lost is missing
    const auto cut = static_cast<std::ptrdiff_t>(taken_before);
    check_same({all.begin(), all.begin() + cut}, {whole.begin(), whole.begin() + cut});
    check_same({all.begin() + cut, all.end()},
               {whole.begin() + cut - static_cast<std::ptrdiff_t>(again), whole.end()});
  }
}

TEST_CASE("nobody says where the nozzle is: nothing moves any more") {
  const PartFolder folder;
  const test::TemporaryFolder state;
  Rig rig(coarse(), small_part(folder));
  rig.options.lost_port_wait_s = 20;
  rig.control.height = [](std::int64_t) { return std::nullopt; };
  std::size_t before = 0;
  rig.wire->on_read = [&] {
    if (before > 0 || rig.executed.size() < 200) return;
    (void)rig.controller();  // lets it do all it can
    before = rig.executed.size();
    rig.port->controller().reset(rig.port->simulated_now());
  };
  const host::PrintOutcome outcome = rig.print();
  CHECK_EQ(outcome.exit_code, host::kExitLinkFault);
  CHECK(laid_nothing_after(rig, before));
}

TEST_CASE("stopped while its port is back but not greeted yet: the heaters go off") {
  const PartFolder folder;
  Rig rig(coarse(), small_part(folder));
  make_pluggable(rig, 20);
  bool back = false;
  const auto reopen = rig.control.reopen;
  rig.control.reopen = [&] {
    back = true;
    return reopen();
  };
  rig.control.stop = [&] { return back ? 1 : 0; };
  rig.wire->on_read = [&] {
    if (rig.executed.size() >= 200) rig.wire->unplug();
  };
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitStopped);
  CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
  CHECK_EQ(rig.controller().bed_target_celsius, 0);
}

TEST_CASE("a print that ended is resumed from its journal, by another program") {
  const PartFolder folder;
  const test::TemporaryFolder state;
  const std::string path = round_part(folder);
  const std::string journal_path = state.path("print.journal");
  const std::vector<LaidPiece> whole = laid_by(print_test::sliced_lines(coarse(), path));
  std::mt19937 random(14);
  for (int i = 0; i < moments(2); ++i) {
    const std::size_t at = 100 + random() % 380;
    CAPTURE(at);
    CAPTURE(i);
    Rig rig(coarse(), path);
    const bool stopped = i % 2 == 0;
    {
      core::Result<host::Journal> journal = new_journal(journal_path);
      REQUIRE(journal.ok());
      rig.control.kept_journal = &journal.value();
      rig.control.stop = [&] { return stopped && rig.executed.size() >= at ? 1 : 0; };
      rig.wire->on_read = [&] {
        if (!stopped && rig.executed.size() >= at) rig.wire->unplug();
      };
      const host::PrintOutcome outcome = rig.print();
      CHECK_EQ(outcome.exit_code, stopped ? host::kExitStopped : host::kExitLinkFault);
    }
    const host::PrintOutcome outcome = print_rest(rig, path, journal_path);
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    check_same(laid_by(rig.executed), whole);
    CHECK_EQ(rig.count("G28 X Y"), 1);
    CHECK_EQ(rig.count("G28"), 2);
    CHECK_EQ(rig.count("G92 Z"), 0);                     // it knows its height
    CHECK_FALSE(host::read_journal(journal_path).ok());  // done: nothing is left to resume
  }
}

TEST_CASE("another print than the one that was started is refused before anything moves") {
  const PartFolder folder;
  const test::TemporaryFolder state;
  const std::string path = small_part(folder);
  const std::string journal_path = state.path("print.journal");
  Rig rig(coarse(), path);
  core::Result<host::Journal> journal = new_journal(journal_path);
  REQUIRE(journal.ok());
  rig.control.kept_journal = &journal.value();
  rig.control.stop = [&] { return rig.executed.size() >= 330 ? 1 : 0; };
  (void)rig.print();
  const auto read = host::read_journal(journal_path);
  REQUIRE(read.ok());

  core::Settings other = coarse();
  // Whatever a layer begins with is another.
  other.road_width = Length::from_mm(0.46);
  other.retraction_mm = 1.1;
  other.lift_speed_mm_s = 11;
  rig.print_plan = print_test::open(other, path);
  rig.control.stop = [] { return 0; };
  rig.options.resumption = host::Resumption{read.value().record, true, 0};
  const std::size_t before = rig.executed.size();
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitBadInput);
  CHECK_NE(outcome.message.find("not the one"), std::string::npos);
  CHECK_EQ(rig.executed.size(), before);
}
