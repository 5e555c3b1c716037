// Prints on Klipper that are interrupted: its restart, its port gone and back, rind killed, a pause
// longer than its idle timeout. What is laid in all is what the whole print lays; what is in doubt
// is laid once more, and nothing is missing.
#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "host/printing/journal.h"
#include "host/printing/reported_position.h"
#include "host/system/exit_codes.h"
#include "tests/host/print_rig.h"
#include "tests/support/laid_roads.h"
#include "tests/support/temporary_folder.h"

using core::Length;
using host::UserRequest;
using print_test::BreakablePort;
using print_test::Rig;
using test::laid_by;
using test::LaidPiece;
using test::PartFolder;

namespace {

constexpr std::uint64_t kSeed = 20;

// Klipper says no `start` that would be worth waiting for.
constexpr double kBanner_s = 0.05;

core::Settings coarse() {
  core::Settings settings;
  settings.layer_height = Length::from_mm(0.3);
  settings.wall_thickness = Length::from_mm(0.9);
  return settings;
}

std::string small_part(const PartFolder& folder) {
  return folder.add("part.stl", parts::together({parts::box({5, 5, 0}, 9, 8, 3),
                                                 parts::box({6, 6, 0}, 3, 3, 4)}));
}

firmware_link::VirtualControllerOptions klipper(bool force_move) {
  firmware_link::VirtualControllerOptions options;
  options.dialect = firmware_link::VirtualDialect::kKlipper;
  options.force_move = force_move;
  return options;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// What an undisturbed print lays: no arcs, because [gcode_arcs] cannot be asked for.
std::vector<LaidPiece> whole_print(const std::string& path) {
  Rig rig(coarse(), path, klipper(false));
  rig.options.banner_wait_s = kBanner_s;
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  REQUIRE_EQ(outcome.exit_code, host::kExitDone);
  std::vector<LaidPiece> laid = laid_by(rig.executed);
  REQUIRE_GT(laid.size(), 100);
  return laid;
}

// Every piece of the whole at least once, in order, and nothing else: `all` is the whole with
// stretches gone over again.
void check_none_missing(const std::vector<LaidPiece>& all, const std::vector<LaidPiece>& whole,
                        std::size_t repeats_max) {
  std::size_t at = 0;
  std::size_t repeats = 0;
  for (const LaidPiece& piece : all) {
    if (at < whole.size() && piece == whole[at]) {
      ++at;
      continue;
    }
    // Back to a piece that was laid before.
    const auto begin = whole.begin() + static_cast<std::ptrdiff_t>(at);
    const auto back = std::find(std::make_reverse_iterator(begin), whole.rend(), piece);
    CAPTURE(at);
    REQUIRE(back != whole.rend());
    const auto again = static_cast<std::size_t>(whole.rend() - back) - 1;
    repeats += at - again;
    at = again + 1;
  }
  CHECK_EQ(at, whole.size());
  CHECK_LE(repeats, repeats_max);
}

host::JournalHead some_head() {
  host::JournalHead head;
  head.version = "test";
  return head;
}

// The wire loses what is written from now on, and is then cut: lines in flight that never arrive.
class LosingPort final : public firmware_link::BytePort {
 public:
  explicit LosingPort(firmware_link::BytePort& inner) : inner_(inner) {}
  std::function<bool()> loses;  // asked before each line
  [[nodiscard]] std::size_t write(std::span<const std::byte> bytes) override {
    if (lost_ || (loses && loses())) {
      lost_ = lost_ || !bytes.empty();
      return bytes.size();
    }
    return inner_.write(bytes);
  }
  [[nodiscard]] std::size_t read(std::span<std::byte> into, int timeout_ms) override {
    if (lost_ && ++reads_ > 3) gone_ = true;
    return gone_ ? 0 : inner_.read(into, timeout_ms);
  }
  [[nodiscard]] firmware_link::PortState state() const override {
    return gone_ ? firmware_link::PortState::kLost : inner_.state();
  }

 private:
  firmware_link::BytePort& inner_;
  bool lost_ = false;
  bool gone_ = false;
  int reads_ = 0;
};

host::MachineState at(std::int64_t x_um, std::int64_t z_um = 300) {
  host::MachineState state;
  state.x_um = x_um;
  state.y_um = 7'000;
  state.z_um = z_um;
  return state;
}

host::ReportedPosition told(double x_mm, double z_mm, bool homed) {
  host::ReportedPosition told;
  told.place.x_mm = x_mm;
  told.place.y_mm = 7;
  told.place.z_mm = z_mm;
  told.homed = homed;
  return told;
}

}  // namespace

TEST_CASE("which lines were taken is known by the place, and nothing else") {
  host::JournalRecord record;
  record.sure = 50;
  record.accepted = 100;
  record.lines_more = 4;
  record.line_kinds = 0b1011;
  record.nozzle_z_um = 300;
  record.state = host::PrintState::kPortLost;
  CHECK_EQ(host::commands_sent(record), 103);
  const std::vector<host::MachineState> places = {at(1'000), at(2'000), at(2'000), at(4'000)};
  const auto before = [&](std::int64_t command) {
    return places.at(static_cast<std::size_t>(command - 100));
  };
  const auto point = [&](const host::ReportedPosition& where) {
    return host::resume_point_at(record, where, 103, before);
  };
  CHECK_EQ(point(told(1, 0.3, true)).command, 100);
  CHECK_EQ(point(told(2, 0.3, true)).command, 101);  // the first of two alike
  CHECK_EQ(point(told(4, 0.3, true)).command, 103);
  CHECK(point(told(4, 0.3, true)).lives);
  CHECK_FALSE(point(told(4, 0.3, false)).lives);  // it stood idle
  CHECK_EQ(point(told(4, 0.3, false)).command, 103);
  CHECK_EQ(point(told(0, 0, false)).command, 50);  // restarted
  CHECK_FALSE(point(told(0, 0, false)).lives);
  CHECK_EQ(point(told(9, 0.3, true)).command, 50);  // homed by hand
  record.nozzle_z_um = 5'300;                       // parked
  CHECK_EQ(point(told(5, 5.3, true)).command, 100);
  CHECK_EQ(point(told(0, 0, false)).command, 50);
  record.state = host::PrintState::kStopped;
  CHECK_EQ(point(told(1, 5.3, true)).command, 100);
  CHECK_EQ(point(told(0, 0, false)).command, 100);
  record.state = host::PrintState::kReset;
  CHECK_EQ(point(told(0, 0, false)).command, 50);
}

TEST_CASE("a running Klipper whose port was lost: lines that never came are laid, none twice") {
  const PartFolder folder;
  const std::string path = small_part(folder);
  const std::vector<LaidPiece> whole = whole_print(path);
  std::mt19937 random(kSeed);
  for (int i = 0; i < 4; ++i) {
    Rig rig(coarse(), path, klipper(false));
    rig.options.banner_wait_s = kBanner_s;
    const std::size_t moment = 20 + random() % 400;
    CAPTURE(kSeed);
    CAPTURE(moment);
    LosingPort losing(*rig.port);
    losing.loses = [&] { return rig.executed.size() >= moment; };
    rig.wire = std::make_unique<BreakablePort>(losing);
    rig.options.lost_port_wait_s = 30;
    rig.control.reopen = [&rig]() -> std::unique_ptr<firmware_link::BytePort> {
      return std::make_unique<BreakablePort>(*rig.port);
    };
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    CHECK_EQ(outcome.link.recoveries, 1);
    check_none_missing(laid_by(rig.executed), whole, firmware_link::kWindowLinesMax);
    CHECK_EQ(rig.count("G28"), 1);  // it knew where it was
  }
}

TEST_CASE("Klipper restarted in mid-print goes on with [force_move], and does nothing without") {
  const PartFolder folder;
  const std::string path = small_part(folder);
  const std::vector<LaidPiece> whole = whole_print(path);
  for (const bool force_move : {true, false}) {
    CAPTURE(force_move);
    Rig rig(coarse(), path, klipper(force_move));
    rig.options.banner_wait_s = kBanner_s;
    rig.options.lost_port_wait_s = 30;
    rig.control.height = [](std::int64_t z_um) { return z_um; };
    bool restarted = false;
    std::size_t before = 0;
    rig.wire->on_read = [&] {
      if (restarted || rig.executed.size() < 230) return;
      restarted = true;
      (void)rig.controller();  // a restart lets what is planned move first
      before = rig.executed.size();
      rig.port->controller().restart(std::chrono::milliseconds(50), rig.port->simulated_now());
    };
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    if (force_move) {
      CHECK_EQ(outcome.exit_code, host::kExitDone);
      check_none_missing(laid_by(rig.executed), whole, 400);
      CHECK_EQ(rig.count("G28 X Y"), 1);
      CHECK_EQ(rig.port->controller().totals().cold_extrusions, 0);
    } else {
      CHECK_EQ(outcome.exit_code, host::kExitLinkFault);
      CHECK(contains(outcome.message, "enable_force_move: True"));
      CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
      CHECK_EQ(
          laid_by(rig.executed).size(),
          laid_by({rig.executed.begin(), rig.executed.begin() + static_cast<long>(before)}).size());
    }
  }
}

TEST_CASE("rind resume: Klipper alive, restarted, or asleep") {
  const PartFolder folder;
  const test::TemporaryFolder state;
  const std::string path = small_part(folder);
  const std::vector<LaidPiece> whole = whole_print(path);
  const std::string journal_path = state.path("print.journal");
  bool restarts = false;
  bool force_move = false;
  bool stopped = false;
  SUBCASE("alive, its port was cut") {}
  SUBCASE("alive, stopped") { stopped = true; }
  SUBCASE("restarted, and has force_move") { restarts = force_move = true; }
  SUBCASE("restarted, stopped before") { restarts = force_move = stopped = true; }
  SUBCASE("restarted, without") { restarts = true; }
  Rig rig(coarse(), path, klipper(force_move));
  rig.options.banner_wait_s = kBanner_s;
  {
    core::Result<host::Journal> journal = host::Journal::create(journal_path, some_head());
    REQUIRE(journal.ok());
    rig.control.kept_journal = &journal.value();
    rig.control.stop = [&] { return stopped && rig.executed.size() >= 260 ? 1 : 0; };
    rig.wire->on_read = [&] {
      if (!stopped && rig.executed.size() >= 260) rig.wire->unplug();
    };
    (void)rig.print();
  }
  (void)rig.controller();
  if (restarts) {
    rig.port->controller().restart(std::chrono::milliseconds(50), rig.port->simulated_now());
  }
  const auto read = host::read_journal(journal_path);
  REQUIRE(read.ok());
  core::Result<host::Journal> journal = host::Journal::go_on(journal_path);
  REQUIRE(journal.ok());
  rig.wire = std::make_unique<BreakablePort>(*rig.port);
  rig.job = print_test::open(coarse(), path);
  rig.control.stop = [] { return 0; };
  rig.control.kept_journal = &journal.value();
  rig.options.resumption =
      host::Resumption{read.value().record, true, read.value().record.nozzle_z_um};
  const std::size_t before = rig.executed.size();
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  if (restarts && !force_move) {
    CHECK_EQ(outcome.exit_code, host::kExitLinkFault);
    CHECK(contains(outcome.message, "[force_move]"));
    CHECK(contains(outcome.message, "nothing was heated or moved"));
    CHECK_EQ(
        laid_by(rig.executed).size(),
        laid_by({rig.executed.begin(), rig.executed.begin() + static_cast<long>(before)}).size());
    CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
    CHECK(host::read_journal(journal_path).ok());  // it can still be gone on with
    return;
  }
  CHECK_EQ(outcome.exit_code, host::kExitDone);
  check_none_missing(laid_by(rig.executed), whole, restarts ? 400 : 4);
  CHECK_EQ(rig.count("G28 X Y"), 1);
}

TEST_CASE("what was not sent is not said to be, and what was is confirmed") {
  const PartFolder folder;
  const std::string path = small_part(folder);
  Rig rig(coarse(), path, klipper(false));
  rig.options.banner_wait_s = kBanner_s;
  bool happened = false;
  bool alarm = false;
  SUBCASE("a move out of range") { alarm = true; }
  SUBCASE("a shutdown") {}
  rig.wire->on_read = [&] {
    if (happened || rig.executed.size() < 200) return;
    happened = true;
    if (alarm) {
      rig.wire->say("!! Move out of range: 999.000 0.000 0.500 [0.000]\n");
    } else {
      rig.port->controller().halt("Lost communication with MCU 'mcu'\n", rig.port->simulated_now());
    }
  };
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitLinkFault);
  if (alarm) {
    CHECK(contains(outcome.message, "nozzle lifted and heaters off, as the controller confirms"));
  } else {
    CHECK(contains(outcome.message, "Lost communication with MCU 'mcu'"));
    CHECK(contains(outcome.message, "FIRMWARE_RESTART"));
    CHECK(contains(outcome.message, "nothing more was sent"));
  }
  CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
}
