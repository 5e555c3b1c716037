// A ready G-code file, killed at random moments and resumed: the controller, which lives on, gets
// every command of the file once, in order, byte for byte. Nothing is kept of what it got, so that
// a file of any size can be tried:
//
//     RIND_READY_FILE=part.gcode RIND_KILLS=20 host_printing_ready_kills_test
//
// (or part.bgcode, with RIND_READY_TEXT=part.gcode: the same commands as plain text). The program
// itself is killed by tools/kill_ready.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "firmware_link/virtual/virtual_controller.h"
#include "host/printing/journal.h"
#include "host/system/exit_codes.h"
#include "tests/host/print_rig.h"
#include "tests/support/bgcode_file.h"
#include "tests/support/own_lines.h"
#include "tests/support/temporary_folder.h"

namespace {

// The commands of a plain file, one after the other.
class FileCommands {
 public:
  explicit FileCommands(const std::string& path) : file_(path, std::ios::binary) {}

  // Empty at the end.
  std::string next() {
    for (std::string line; std::getline(file_, line);) {
      line.resize(std::min(line.find(';'), line.size()));
      while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.pop_back();
      if (!line.empty() && line != "G92 E0") return line;
    }
    return {};
  }

 private:
  std::ifstream file_;
};

// A controller that lives on, and looks at each command that it gets.
class Printer {
 public:
  Printer(const std::string& text, std::size_t kills, std::uint64_t seed, std::size_t commands)
      : wanted_(text), expected_(wanted_.next()) {
    std::mt19937_64 random(seed);
    for (std::size_t i = 0; i < kills; ++i) moments_.push_back(20 + random() % (commands - 20));
    std::sort(moments_.begin(), moments_.end());
    firmware_link::VirtualControllerOptions options;
    options.executed = [this](const firmware_link::ExecutedCommand& command) {
      look_at(std::string(command.words), std::string(command.text));
    };
    now_ = host::link_now();
    controller_ = std::make_unique<firmware_link::VirtualController>(options, now_);
  }

  std::size_t got = 0;  // of the file's
  std::size_t own = 0;  // of rind's
  std::string wrong;    // the first command that is neither
  bool dead = false;    // the host

  [[nodiscard]] bool ended() const { return expected_.empty(); }

  [[nodiscard]] std::size_t write(std::span<const std::byte> bytes) {
    return dead ? 0 : controller_->input(bytes, now_);
  }
  // As VirtualPort at speed 0: whenever an answer is owed, time jumps to it.
  [[nodiscard]] std::size_t read(std::span<std::byte> into) {
    while (!dead) {
      controller_->advance(now_);
      if (const std::size_t count = controller_->output(into); count > 0) return count;
      if (!controller_->owes_answer()) return 0;
      const auto next = controller_->next_event();
      if (!next) return 0;
      now_ = std::max(now_, *next);
    }
    return 0;
  }

 private:
  void look_at(const std::string& words, const std::string& text) {
    if (words == expected_) {
      ++got;
      expected_ = wanted_.next();
      if (!moments_.empty() && got >= moments_.front()) {
        while (!moments_.empty() && got >= moments_.front()) moments_.erase(moments_.begin());
        dead = true;
      }
      return;
    }
    ++own;
    const bool lays = text.starts_with("G1 X") && text.find(" E") != std::string::npos;
    if (lays && wrong.empty()) {
      wrong = fmt::format("command {}: '{}', the file has '{}'", got, words, expected_);
    }
  }

  FileCommands wanted_;
  std::string expected_;
  std::vector<std::size_t> moments_;
  std::unique_ptr<firmware_link::VirtualController> controller_;
  firmware_link::Instant now_;
};

class Wire final : public firmware_link::BytePort {
 public:
  explicit Wire(Printer& printer) : printer_(printer) {}
  [[nodiscard]] std::size_t write(std::span<const std::byte> bytes) override {
    return printer_.write(bytes);
  }
  [[nodiscard]] std::size_t read(std::span<std::byte> into, int) override {
    return printer_.read(into);
  }
  [[nodiscard]] firmware_link::PortState state() const override {
    return printer_.dead ? firmware_link::PortState::kLost : firmware_link::PortState::kOpen;
  }

 private:
  Printer& printer_;
};

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// One life of the program. True: the print has come to its end.
bool live(const std::string& path, const std::string& journal_path, Printer& printer) {
  printer.dead = false;
  core::Result<host::JournalContent> left = host::read_journal(journal_path);
  core::Result<host::Journal> journal =
      left.ok() ? host::Journal::reopen(journal_path) : host::Journal::create(journal_path, {});
  REQUIRE(journal.ok());
  host::PrintPlan print_plan = print_test::open(core::Settings(), path);
  print_test::ScriptedControl control;
  control.kept_journal = &journal.value();
  std::string grave;
  control.stop = [&] {
    if (!printer.dead) return 0;
    // What it does from now on, it does no more.
    if (grave.empty()) grave = bytes_of(journal_path);
    return 2;
  };
  host::PrintOptions options;
  options.banner_wait_s = 0.05;
  if (left.ok()) {
    options.resumption =
        host::Resumption{left.value().record, true, left.value().record.nozzle_z_um};
  }
  Wire wire(printer);
  host::Reporter reporter({.quiet = true, .json = false, .stdout_taken = false});
  const host::PrintOutcome outcome =
      host::print_part({print_plan, wire, control, reporter, options, host::steady_seconds()});
  if (outcome.exit_code == host::kExitDone) return true;
  CAPTURE(outcome.message);
  REQUIRE(printer.dead);
  if (!grave.empty()) {
    std::ofstream(journal_path, std::ios::binary | std::ios::trunc) << grave;
  }
  return false;
}

void kill_and_resume(const std::string& path, const std::string& text, std::size_t kills) {
  const test::TemporaryFolder folder;
  const std::uint64_t seed = std::random_device()();
  CAPTURE(seed);
  FileCommands all(text);
  std::size_t commands = 0;
  while (!all.next().empty()) ++commands;
  Printer printer(text, kills, seed, commands);
  std::size_t lives = 1;
  while (!live(path, folder.path("journal"), printer)) ++lives;
  CHECK_EQ(printer.wrong, "");
  CHECK(printer.ended());
  CHECK_EQ(printer.got, commands);
  MESSAGE(commands << " commands, " << printer.own << " of rind's own, " << lives
                   << " lives, at most " << static_cast<double>(host::peak_rss_bytes()) / 1e6
                   << " MB");
}

std::string short_segments(std::size_t commands) {
  std::string text = "M104 S200\nG28\nG90\nM82\nG1 X20 Y20 Z.2 F6000\nM204 P900\n";
  double filament = 0;
  for (std::size_t i = 0; i < commands; ++i) {
    if (i % 700 == 0)
      text += fmt::format(";LAYER_CHANGE\nG1 Z{:.2f}\n", 0.2 + 0.2 * static_cast<double>(i / 700));
    filament += 0.00101;
    const auto turn = static_cast<double>(i) * 0.01;
    text += fmt::format("G1 X{:.3f} Y{:.3f} E{:.5f} F{}\n", 90 + 9 * std::cos(turn),
                        90 + 9 * std::sin(turn), filament, 4'800 + 600 * (i % 3));
  }
  return text + "M104 S0\n";
}

}  // namespace

TEST_CASE("a file that is killed at random moments is printed whole, each command once") {
  const char* file = std::getenv("RIND_READY_FILE");
  const char* told = std::getenv("RIND_KILLS");
  const std::size_t kills = told != nullptr ? std::strtoul(told, nullptr, 10) : 4;
  if (file != nullptr) {
    const char* text = std::getenv("RIND_READY_TEXT");
    kill_and_resume(file, text != nullptr ? text : file, kills);
    return;
  }
  const test::PartFolder folder;
  const std::string text = short_segments(4'000);
  const std::string plain = folder.add_text("part.gcode", text);
  kill_and_resume(plain, plain, kills);
  test::BgcodeForm form;
  form.encoding = 0;  // MeatPack leaves out what a number may go without
  kill_and_resume(folder.add_text("part.bgcode", test::bgcode_of(text, form)), plain, kills);
}
