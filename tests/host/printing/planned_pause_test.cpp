// What is done at heights of a print: pauses, lines of G-code, temperatures; once each, also in a
// print that is interrupted there and resumed.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/system/exit_codes.h"
#include "tests/host/interrupted_print.h"
#include "tests/support/temporary_folder.h"

using host::UserRequest;
using print_test::Rig;
using test::laid_by;

namespace {

core::Settings acting() {
  core::Settings settings = print_test::coarse();
  settings.at_height = {"1.2 gcode G91", "1.2 M117 here", "1.5 nozzle_celsius 220", "2.1 pause",
                        "99 M117 never"};
  // Pauses are far from the part, the end is at the front left.
  settings.centre = false;
  settings.part_x = settings.part_y = core::Length::from_mm(40);
  return settings;
}

// Without what stands for a pause in a file.
std::vector<std::string> lines_to_print(const std::string& part) {
  std::vector<std::string> lines = print_test::given_lines(acting(), part);
  std::erase(lines, "M0");
  return lines;
}

bool away(const Rig& rig) {
  const auto state = rig.port->controller().state();
  return state.x_mm == 295 && state.y_mm == 295 && state.z_mm > 10;
}

// Resumes each pause, and counts them; more than a few are no end.
struct Resumer {
  Rig& rig;
  int pauses = 0;
  bool was_away = false;

  std::optional<UserRequest> request() {
    const bool now = away(rig);
    const bool new_pause = now && !was_away;
    was_away = now;
    if (!new_pause) return std::nullopt;
    return ++pauses > 3 ? UserRequest::kStop : UserRequest::kResume;
  }
};

// Prints with a journal, and ends early where `now` holds: stopped, or by an unplugged port.
void print_until(Rig& rig, const std::string& journal_path, bool stopped,
                 const std::function<bool()>& now) {
  core::Result<host::Journal> journal = print_test::new_journal(journal_path);
  REQUIRE(journal.ok());
  rig.control.kept_journal = &journal.value();
  rig.control.stop = [&] { return stopped && now() ? 1 : 0; };
  rig.wire->on_read = [&] {
    if (!stopped && now()) rig.wire->unplug();
  };
  CHECK_NE(rig.print().exit_code, host::kExitDone);
  rig.control.kept_journal = nullptr;
  rig.control.stop = nullptr;
  rig.wire->on_read = nullptr;
}

}  // namespace

TEST_CASE("a file has the pause's G-code, and what is done comes before the layer's roads") {
  const test::PartFolder folder;
  const std::vector<std::string> lines =
      print_test::sliced_lines(acting(), print_test::small_part(folder));
  const auto at = [&](const std::string& text) {
    CAPTURE(text);
    CHECK_EQ(std::count(lines.begin(), lines.end(), text), 1);
    return std::find(lines.begin(), lines.end(), text) - lines.begin();
  };
  CHECK_EQ(std::count(lines.begin(), lines.end(), "M117 never"), 0);
  // Off the part; the user's lines; rind's modes; the fan; over the part and down again.
  const auto here = static_cast<std::size_t>(at("M117 here"));
  CHECK_EQ(lines[here - 3], "G1 E-1 F2400");
  CHECK_EQ(lines[here - 2].substr(0, 9), "G0 Z11.2 ");
  CHECK_EQ(lines[here - 1], "G91");
  const std::vector<std::string> behind(lines.begin() + static_cast<std::ptrdiff_t>(here) + 1,
                                        lines.begin() + static_cast<std::ptrdiff_t>(here) + 7);
  CHECK(behind == std::vector<std::string>{"G21", "G90", "M83", "G92 E0", "M400", "M106 S255"});
  CHECK_EQ(lines[here + 7].substr(0, 8), "G0 Z11.2");
  CHECK_EQ(lines[here + 8].substr(0, 4), "G0 X");
  CHECK_EQ(lines[here + 9].substr(0, 7), "G0 Z1.5");
  CHECK_EQ(lines[here + 10], "G1 E1 F2400");
  CHECK_LT(at("M117 here"), at("M104 S220"));
  CHECK_LT(at("M104 S220"), at("M0"));
}

TEST_CASE("a print pauses at the height, and is the file's otherwise") {
  const test::PartFolder folder;
  const std::string part = print_test::small_part(folder);
  Rig rig(acting(), part);
  rig.options.banner_wait_s = 0.05;
  Resumer resumer{rig};
  rig.control.request = [&] { return resumer.request(); };
  CHECK_EQ(rig.print().exit_code, host::kExitDone);
  CHECK_EQ(resumer.pauses, 1);
  CHECK_EQ(rig.count("M117 here"), 1);
  CHECK_EQ(rig.count("M104 S220"), 1);
  CHECK_EQ(rig.count("M0"), 0);
  const auto laid = laid_by(rig.executed);
  CHECK((laid == laid_by(lines_to_print(part))));
  CHECK_GT(laid.size(), 100);
}

TEST_CASE("interrupted around an action, the resumed print does not repeat it") {
  const test::PartFolder folder;
  const test::TemporaryFolder state;
  const std::string part = print_test::small_part(folder);
  const std::string journal_path = state.path("print.journal");
  const std::vector<std::string> whole = lines_to_print(part);
  const auto action =
      static_cast<std::size_t>(std::find(whole.begin(), whole.end(), "M117 here") - whole.begin());
  REQUIRE_LT(action, whole.size());
  for (const std::size_t at : {action - 4, action + 1, action + 12, action + 20}) {
    for (const bool stopped : {false, true}) {
      CAPTURE(at);
      CAPTURE(stopped);
      Rig rig(acting(), part);
      rig.options.banner_wait_s = 0.05;
      print_until(rig, journal_path, stopped, [&] { return rig.executed.size() >= at; });
      Resumer resumer{rig};
      rig.control.request = [&] { return resumer.request(); };
      const host::PrintOutcome outcome = print_test::print_rest(rig, part, journal_path, acting());
      CAPTURE(outcome.message);
      CHECK_EQ(outcome.exit_code, host::kExitDone);
      CHECK_EQ(rig.count("M117 here"), 1);
      CHECK_GE(resumer.pauses, 1);
      CHECK((laid_by(rig.executed) == laid_by(whole)));
    }
  }
}

TEST_CASE("a print that ended in its own pause goes on behind it, as hot as it was") {
  const test::PartFolder folder;
  const test::TemporaryFolder state;
  const std::string part = print_test::small_part(folder);
  const std::string journal_path = state.path("print.journal");
  for (const bool stopped : {false, true}) {
    CAPTURE(stopped);
    Rig rig(acting(), part);
    rig.options.banner_wait_s = 0.05;
    print_until(rig, journal_path, stopped, [&] { return away(rig); });
    const auto read = host::read_journal(journal_path);
    REQUIRE(read.ok());
    CHECK_EQ(read.value().record.machine.nozzle_tenths, 2'200);
    CHECK_GT(read.value().record.last_planned, 0);
    const std::size_t before = rig.executed.size();
    const host::PrintOutcome outcome = print_test::print_rest(rig, part, journal_path, acting());
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);  // nobody had to resume it
    const auto rest = rig.executed.begin() + static_cast<std::ptrdiff_t>(before);
    CHECK_EQ(std::count(rest, rig.executed.end(), "M109 S220"), 1);
    CHECK_EQ(std::count(rest, rig.executed.end(), "M117 here"), 0);
    CHECK((laid_by(rig.executed) == laid_by(lines_to_print(part))));
  }
}
