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
#include "host/system/exit_codes.h"
#include "tests/host/interrupted_print.h"
#include "tests/support/temporary_folder.h"

using print_test::BreakablePort;
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

constexpr std::uint64_t kSeed = 20;

// Klipper says no `start` that would be worth waiting for.
constexpr double kBanner_s = 0.05;

firmware_link::VirtualControllerOptions klipper(bool force_move) {
  firmware_link::VirtualControllerOptions options;
  options.dialect = firmware_link::VirtualDialect::kKlipper;
  options.klipper.force_move = force_move;
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

}  // namespace

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
    make_pluggable(rig, 30);
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    CHECK_EQ(outcome.link.recoveries, 1);
    check_none_missing(laid_by(rig.executed), whole, firmware_link::kWindowLinesMax);
    CHECK_EQ(rig.count("G28"), 1);  // it knew where it was
  }
}

TEST_CASE("Klipper restarted in mid-print resumes with [force_move], and does nothing without") {
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
      CHECK(laid_nothing_after(rig, before));
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
    core::Result<host::Journal> journal = new_journal(journal_path);
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
  const std::size_t before = rig.executed.size();
  const host::PrintOutcome outcome = print_rest(rig, path, journal_path);
  CAPTURE(outcome.message);
  if (restarts && !force_move) {
    CHECK_EQ(outcome.exit_code, host::kExitLinkFault);
    CHECK(contains(outcome.message, "[force_move]"));
    CHECK(contains(outcome.message, "nothing was heated or moved"));
    CHECK(laid_nothing_after(rig, before));
    CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
    CHECK(host::read_journal(journal_path).ok());  // it can still be resumed
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
