// Any two interruptions in a row, at random moments: rind is killed, the board is reset, the cable
// comes off, the power fails. Every road is laid, as a whole, in order, and at most the last moves
// before each interruption are laid twice (host/README.md). What counts is what has moved, not what
// was accepted.
//
// RIND_MOMENTS=200 tries so many pairs instead of the few that fit into every run; RIND_SEED=N one
// of them.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "host/printing/command_history.h"  // kBlockLengthUm
#include "host/printing/journal.h"
#include "host/system/exit_codes.h"
#include "tests/host/mortal_printer.h"
#include "tests/host/print_rig.h"
#include "tests/support/temporary_folder.h"

using core::Length;
using print_test::MortalPrinter;
using test::LaidPiece;

namespace {

// What a planner and a line hold (resume_point.h).
constexpr std::size_t kTwiceMax = firmware_link::kPlannerBlocks + firmware_link::kWindowLinesMax;

enum class Blow { kKill, kReset, kReplug, kPowerCut };

const char* name_of(Blow blow) {
  constexpr const char* kNames[] = {"kill", "reset", "replug", "power cut"};
  return kNames[static_cast<std::size_t>(blow)];
}

core::Settings coarse() {
  core::Settings settings;
  settings.layer_height = Length::from_mm(0.3);
  settings.wall_thickness = Length::from_mm(0.6);
  settings.bed_x = settings.bed_y = Length::from_mm(100);
  return settings;
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// In place, as a disk would have it.
void put_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << bytes;
}

// A host's end of the cable. Bytes wait in the computer until the host listens for answers.
class Cable final : public firmware_link::BytePort {
 public:
  Cable(MortalPrinter& printer, std::function<void(Cable&)> on_read)
      : printer_(printer), on_read_(std::move(on_read)) {}

  // So many of the waiting bytes come through.
  void cut(std::size_t bytes) {
    waiting_.resize(std::min(bytes, waiting_.size()));
    deliver();
    cut_ = true;
  }
  [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }

  [[nodiscard]] std::size_t write(std::span<const std::byte> bytes) override {
    if (cut_) return 0;
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    return bytes.size();
  }
  [[nodiscard]] std::size_t read(std::span<std::byte> into, int) override {
    if (!cut_ && on_read_) on_read_(*this);
    if (cut_) return 0;
    deliver();
    return printer_.read(into);
  }
  [[nodiscard]] firmware_link::PortState state() const override {
    return cut_ ? firmware_link::PortState::kLost : firmware_link::PortState::kOpen;
  }

 private:
  void deliver() {
    (void)printer_.write(waiting_);
    waiting_.clear();
  }

  MortalPrinter& printer_;
  std::function<void(Cable&)> on_read_;
  std::vector<std::byte> waiting_;
  bool cut_ = false;
};

// One print through all that happens to it.
class Fate {
 public:
  Fate(std::uint64_t seed, const core::Settings& settings, std::string part, std::string journal,
       std::size_t whole)
      : random_(seed),
        settings_(settings),
        part_(std::move(part)),
        journal_(std::move(journal)),
        whole_(whole) {
    firmware_link::VirtualControllerOptions options;
    options.bed_x_mm = options.bed_y_mm = 100;
    printer_ = std::make_unique<MortalPrinter>(options);
    board_resets_ = random_() % 2 == 0;
    for (int i = 0; i < 2; ++i) blows_.push_back(static_cast<Blow>(random_() % 4));
    next_at_ = 40 + random_() % 450;
  }

  std::string story;

  // How many pieces, at most, each interruption may have had laid twice.
  [[nodiscard]] std::vector<std::size_t> twice_max() const { return twice_max_; }
  [[nodiscard]] std::vector<LaidPiece> laid() { return printer_->laid(); }

  // False: it did not come to its end.
  [[nodiscard]] bool live() {
    for (int life = 0; life < 8; ++life) {
      const host::PrintOutcome outcome = one_life();
      if (outcome.exit_code == host::kExitDone) {
        printer_->come_to_rest();
        return true;
      }
      if (!died_) {
        story += " [" + outcome.message + "]";
        twice_max_.push_back(kTwiceMax);
      }
      after_death();
      if (!host::read_journal(journal_).ok()) {
        // Cut before its first road, or no record is whole: from the begin.
        story += " from the begin";
        std::filesystem::remove(journal_);
        twice_max_.push_back(whole_);
      }
    }
    return false;
  }

 private:
  host::PrintOutcome one_life() {
    died_.reset();
    core::Result<host::JournalContent> left = host::read_journal(journal_);
    core::Result<host::Journal> journal =
        left.ok() ? host::Journal::reopen(journal_) : host::Journal::create(journal_, {});
    REQUIRE(journal.ok());
    host::PrintPlan print_plan = print_test::open(settings_, part_);
    host::PrintOptions options;
    print_test::ScriptedControl control;
    options.banner_wait_s = 0.05;
    control.kept_journal = &journal.value();
    if (left.ok()) {
      options.resumption =
          host::Resumption{left.value().record, same_boot_, printer_->nozzle_z_um()};
    }
    same_boot_ = true;
    const auto strike = [this](Cable& cable) { maybe_strike(cable); };
    options.lost_port_wait_s = 20;
    control.reopen = [&, this]() -> std::unique_ptr<firmware_link::BytePort> {
      if (died_) return nullptr;
      opened();
      return std::make_unique<Cable>(*printer_, strike);
    };
    control.height = [this](std::int64_t) -> std::optional<std::int64_t> {
      if (died_) return std::nullopt;
      return printer_->nozzle_z_um();
    };
    opened();
    Cable cable(*printer_, strike);
    host::Reporter reporter({.quiet = true, .json = false, .stdout_taken = false});
    control.stop = [this] { return died_ ? 2 : 0; };
    return host::print_part(
        {print_plan, cable, control, reporter, options, host::steady_seconds()});
  }

  // Opening the port resets some boards.
  void opened() {
    if (board_resets_) printer_->reset();
  }

  void maybe_strike(Cable& cable) {
    const std::size_t at = printer_->commands.size();
    if (at >= keep_at_) {
      kept_.push_back({bytes_of(journal_), printer_->laid().size()});
      keep_at_ = at + 16;
    }
    if (kept_.empty() || struck_ == blows_.size() || at < next_at_) return;
    const Blow blow = blows_[struck_++];
    // The second one often comes on the way back from the first.
    next_at_ = at + random_() % (random_() % 2 == 0 ? 30 : 300);
    story += std::string(" ") + name_of(blow) + " at " + std::to_string(at);
    switch (blow) {
      case Blow::kReset:
        printer_->reset();
        twice_max_.push_back(kTwiceMax);
        return;
      case Blow::kReplug:
        cable.cut(random_() % (cable.waiting() + 1));
        twice_max_.push_back(kTwiceMax);
        printer_->live_on(static_cast<int>(random_() % 3) * 40);
        return;
      case Blow::kKill:
        died_ = Grave{bytes_of(journal_), printer_->laid().size()};
        break;
      case Blow::kPowerCut:
        died_ = kept_[random_() % kept_.size()];
        // Or torn, in the midst of a write.
        if (random_() % 2 == 0) tear(bytes_of(journal_), died_->journal);
        same_boot_ = false;
        printer_->reset();
        break;
    }
    cable.cut(random_() % (cable.waiting() + 1));
    twice_max_.push_back(kTwiceMax + printer_->laid().size() - died_->laid);
  }

  void tear(const std::string& now, std::string& old) {
    if (now.size() != old.size()) return;
    const std::size_t at = random_() % now.size();
    old = now.substr(0, at) + old.substr(at);
  }

  // The journal is what the dead one left; its printer goes on with what it has.
  void after_death() {
    if (died_) {
      put_bytes(journal_, died_->journal);
      kept_ = {*died_};  // what came later is on no disk
    }
    if (died_ && same_boot_) printer_->live_on(static_cast<int>(random_() % 3) * 200);
  }

  struct Grave {
    std::string journal;
    std::size_t laid = 0;
  };

  std::mt19937_64 random_;
  core::Settings settings_;
  std::string part_;
  std::string journal_;
  std::size_t whole_;
  std::unique_ptr<MortalPrinter> printer_;
  bool board_resets_ = false;
  bool same_boot_ = true;
  std::vector<Blow> blows_;
  std::size_t struck_ = 0;
  std::size_t next_at_ = 0;
  std::vector<Grave> kept_;  // what a disk might hold
  std::size_t keep_at_ = 0;
  std::optional<Grave> died_;
  std::vector<std::size_t> twice_max_;
};

// Shorter moves may have none (command_history.h).
bool takes_a_block(const LaidPiece& piece) {
  const double farthest =
      std::max(std::abs(piece.to[0] - piece.from[0]), std::abs(piece.to[1] - piece.from[1]));
  return piece.turn != 0 || farthest >= host::kBlockLengthUm * 1e-3 - 1e-9;
}

std::string text_of(const LaidPiece& piece) {
  return fmt::format("({} {}) to ({} {}) at {}, E {} F {} turn {}", piece.from[0], piece.from[1],
                     piece.to[0], piece.to[1], piece.height, piece.filament, piece.feed,
                     piece.turn);
}

// What is laid is the whole, with steps back of bounded length.
void check_laid(const std::vector<LaidPiece>& laid, const std::vector<LaidPiece>& whole,
                const std::vector<std::size_t>& twice_max) {
  std::size_t next = 0;
  std::size_t done = 0;
  std::vector<std::size_t> steps;
  for (std::size_t i = 0; i < laid.size(); ++i) {
    CAPTURE(i);
    CAPTURE(next);
    if (next == whole.size() || !(laid[i] == whole[next])) {
      CAPTURE(text_of(laid[i]));
      CAPTURE(text_of(whole[std::min(next, whole.size() - 1)]));
      std::size_t back = next;
      while (back > 0 && !(laid[i] == whole[back - 1])) --back;
      REQUIRE_GT(back, 0);  // else a road is missing, or another was laid
      steps.push_back(static_cast<std::size_t>(
          std::count_if(whole.begin() + static_cast<std::ptrdiff_t>(back - 1),
                        whole.begin() + static_cast<std::ptrdiff_t>(next), takes_a_block)));
      next = back - 1;
    }
    ++next;
    done = std::max(done, next);
  }
  CHECK_EQ(done, whole.size());
  // Each step belongs to an interruption, and no two to the same one.
  std::vector<std::size_t> allowed = twice_max;
  std::sort(allowed.rbegin(), allowed.rend());
  std::sort(steps.rbegin(), steps.rend());
  CAPTURE(fmt::format("steps back {}, allowed {}", fmt::join(steps, " "), fmt::join(allowed, " ")));
  REQUIRE_LE(steps.size(), allowed.size());
  for (std::size_t i = 0; i < steps.size(); ++i) CHECK_LE(steps[i], allowed[i]);
}

int pairs_wanted() {
  const char* told = std::getenv("RIND_MOMENTS");
  return told != nullptr ? std::atoi(told) : 6;
}

// What is printed in one case.
struct Case {
  core::Settings settings;
  std::string part;
  std::vector<LaidPiece> whole;
};

Case plain_case(const test::PartFolder& folder) {
  const std::string part = folder.add(
      "part.stl", parts::together({parts::box({8, 8, 0}, 6, 5, 3), parts::tube(6, 4, 3, 40)}));
  return {coarse(), part, test::laid_by(print_test::sliced_lines(coarse(), part))};
}

// A shelf, and supports from the bed: a resumed print has to find them again.
Case supported_case(const test::PartFolder& folder) {
  core::Settings settings = coarse();
  settings.supports = core::SupportPlace::kBed;
  const std::string part = folder.add(
      "shelf.stl",
      parts::together({parts::box({8, 8, 0}, 5, 8, 4), parts::box({8, 8, 3}, 14, 8, 1)}));
  return {settings, part, test::laid_by(print_test::sliced_lines(settings, part))};
}

// The same roads out of a ready file, with relative and with absolute filament.
Case ready_case(const test::PartFolder& folder, bool absolute) {
  const std::string part =
      folder.add("ready.stl", parts::together({parts::box({8, 8, 0}, 6, 5, 3)}));
  std::vector<std::string> lines = print_test::sliced_lines(coarse(), part);
  // Something to be set up again after a reset.
  lines.insert(lines.begin() + 30, {"M204 P1200 T1500", "M220 S95"});
  if (absolute) lines = print_test::with_absolute_filament(lines);
  const std::string path = folder.add_text(absolute ? "absolute.gcode" : "relative.gcode",
                                           print_test::dressed(lines, absolute ? "\r\n" : "\n"));
  return {coarse(), path, test::laid_by(lines)};
}

}  // namespace

TEST_CASE("any two interruptions leave no road out, and lay few twice") {
  const test::PartFolder parts_folder;
  const std::vector<Case> cases = {plain_case(parts_folder), supported_case(parts_folder),
                                   ready_case(parts_folder, false), ready_case(parts_folder, true)};
  const char* told = std::getenv("RIND_SEED");
  const std::uint64_t first =
      told != nullptr ? std::strtoull(told, nullptr, 10) : std::random_device()();
  const int pairs = told != nullptr ? 1 : pairs_wanted();
  for (int i = 0; i < pairs; ++i) {
    const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
    const Case& one = cases[seed % cases.size()];
    CAPTURE(seed);
    const test::TemporaryFolder folder;
    Fate fate(seed, one.settings, one.part, folder.path("print.journal"), one.whole.size());
    const bool ended = fate.live();
    CAPTURE(fate.story);
    REQUIRE(ended);
    CHECK_FALSE(std::filesystem::exists(folder.path("print.journal")));
    check_laid(fate.laid(), one.whole, fate.twice_max());
  }
}
