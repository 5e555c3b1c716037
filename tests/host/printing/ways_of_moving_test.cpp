// Accelerations and pressure advance: in files for each firmware, in prints, after a reset, at a
// stop.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "host/system/exit_codes.h"
#include "tests/host/interrupted_print.h"
#include "tests/support/temporary_folder.h"

using firmware_link::VirtualDialect;
using print_test::Rig;
using test::PartFolder;

namespace {

core::Settings told_settings() {
  core::Settings settings = print_test::coarse();
  settings.default_acceleration_mm_s2 = 1'000;
  settings.outer_perimeter_acceleration_mm_s2 = 600;
  settings.loose_acceleration_mm_s2 = 2'000;
  settings.first_layer_acceleration_mm_s2 = 400;
  settings.pressure_advance_s = 0.045;
  settings.arcs = core::ArcUse::kOff;
  settings.start_gcode = {"G28", "M900 K0.2", "G1 X10 F3000"};
  return settings;
}

// Those of them that set how the machine moves.
std::vector<std::string> telling(const std::vector<std::string>& lines) {
  std::vector<std::string> found;
  for (const std::string& line : lines) {
    for (const char* word : {"M204", "M900", "M572", "SET_PRESSURE_ADVANCE"}) {
      if (line.starts_with(word)) found.push_back(line);
    }
  }
  return found;
}

std::size_t index_of(const std::vector<std::string>& lines, const std::string& line,
                     std::size_t from = 0) {
  const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(from);
  return static_cast<std::size_t>(std::find(begin, lines.end(), line) - lines.begin());
}

}  // namespace

TEST_CASE("a file is spelled for its firmware, and lays the same") {
  const PartFolder folder;
  const std::string path = print_test::small_part(folder);
  core::Settings settings = told_settings();
  const std::vector<std::string> marlin = print_test::sliced_lines(settings, path);
  const std::vector<std::string> told = telling(marlin);
  REQUIRE_GT(told.size(), 6);
  CHECK_EQ(told[0], "M900 K0.2");  // the user's own
  CHECK_EQ(told[1], "M900 K0.045");
  CHECK_EQ(told[2], "M204 S400");
  CHECK_EQ(told.back(), "M204 S1000");
  CHECK_EQ(std::count(told.begin(), told.end(), "M204 S400"), 1);
  CHECK_EQ(index_of(marlin, told.back(), marlin.size() - 3), marlin.size() - 2);  // before M84
  for (std::size_t i = 3; i < told.size(); ++i) CHECK(told[i] != told[i - 1]);
  for (const auto& [flavor, advance, acceleration] :
       {std::tuple(core::GcodeFlavor::kKlipper, "SET_PRESSURE_ADVANCE ADVANCE=0.045", "M204 S400"),
        std::tuple(core::GcodeFlavor::kRepRapFirmware, "M572 D0 S0.045", "M204 P400 T400")}) {
    settings.gcode_flavor = flavor;
    const std::vector<std::string> lines = print_test::sliced_lines(settings, path);
    const std::vector<std::string> other = telling(lines);
    REQUIRE_EQ(other.size(), told.size());
    CHECK_EQ(other[1], advance);
    CHECK_EQ(other[2], acceleration);
    CHECK_EQ(lines.size(), marlin.size());
    CHECK(test::laid_by(lines) == test::laid_by(marlin));
  }
}

TEST_CASE("a print is told what the file of its controller's flavor has") {
  const PartFolder folder;
  const std::string path = print_test::small_part(folder);
  for (const auto& [spoken, flavor] :
       {std::pair(VirtualDialect::kMarlin, core::GcodeFlavor::kMarlin),
        std::pair(VirtualDialect::kPrusa, core::GcodeFlavor::kMarlin),
        std::pair(VirtualDialect::kKlipper, core::GcodeFlavor::kKlipper),
        std::pair(VirtualDialect::kRepRap, core::GcodeFlavor::kRepRapFirmware)}) {
    const VirtualDialect dialect = spoken;
    CAPTURE(static_cast<int>(dialect));
    core::Settings settings = told_settings();
    settings.start_gcode = {"G28"};
    firmware_link::VirtualControllerOptions options;
    options.dialect = dialect;
    Rig rig(settings, path, options);
    rig.options.banner_wait_s = 0.05;
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    CHECK_EQ(rig.port->controller().totals().unknown_commands, 0);
    settings.gcode_flavor = flavor;
    const std::vector<std::string> told = telling(rig.executed);
    const std::vector<std::string> wanted = telling(print_test::sliced_lines(settings, path));
    REQUIRE_EQ(told.size(), wanted.size());
    for (std::size_t i = 0; i < told.size(); ++i) CHECK_EQ(told[i], wanted[i]);
  }
}

TEST_CASE("after a reset the controller is told again, before it moves") {
  const PartFolder folder;
  const std::string path = print_test::small_part(folder);
  for (const std::size_t at : {60U, 300U}) {
    CAPTURE(at);
    Rig rig(told_settings(), path);
    rig.options.lost_port_wait_s = 20;
    rig.control.height = [](std::int64_t z_um) { return z_um; };
    std::size_t before = 0;
    rig.wire->on_read = [&] {
      if (before > 0 || rig.executed.size() < at) return;
      (void)rig.controller();
      before = rig.executed.size();
      rig.port->controller().reset(rig.port->simulated_now());
    };
    const host::PrintOutcome outcome = rig.print();
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    const std::vector<std::string> then(rig.executed.begin() + static_cast<std::ptrdiff_t>(before),
                                        rig.executed.end());
    const std::size_t homing = index_of(then, "G28 X Y");
    REQUIRE_LT(homing, then.size());
    // The user's own line comes before what the settings say, as in the start.
    CHECK_LT(index_of(then, "M900 K0.2"), index_of(then, "M900 K0.045"));
    CHECK_LT(index_of(then, "M900 K0.045"), homing);
    // With the acceleration of the command that it resumes before.
    std::string last;
    for (std::size_t i = 0; i < homing; ++i) {
      if (then[i].starts_with("M204")) last = then[i];
    }
    CHECK_EQ(last.empty(), false);
    const std::vector<std::string> given =
        telling({rig.executed.begin(), rig.executed.begin() + static_cast<std::ptrdiff_t>(before)});
    CHECK(std::find(given.begin(), given.end(), last) != given.end());
    CHECK_EQ(rig.executed[rig.executed.size() - 2], "M204 S1000");
  }
}

TEST_CASE("another program that resumes tells the controller what the print has told it") {
  const PartFolder folder;
  const test::TemporaryFolder state;
  const std::string path = print_test::small_part(folder);
  const std::string journal_path = state.path("print.journal");
  const core::Settings settings = told_settings();
  const std::vector<std::string> whole = telling(print_test::sliced_lines(settings, path));
  for (const std::size_t at : {70U, 260U}) {
    CAPTURE(at);
    Rig rig(settings, path);
    {
      core::Result<host::Journal> journal = print_test::new_journal(journal_path);
      REQUIRE(journal.ok());
      rig.control.kept_journal = &journal.value();
      rig.control.stop = [&] { return rig.executed.size() >= at ? 1 : 0; };
      CHECK_EQ(rig.print().exit_code, host::kExitStopped);
    }
    const std::vector<std::string> first = telling(rig.executed);
    const std::size_t before = rig.executed.size();
    const host::PrintOutcome outcome = print_test::print_rest(rig, path, journal_path, settings);
    CAPTURE(outcome.message);
    CHECK_EQ(outcome.exit_code, host::kExitDone);
    // The user's line, and what was told last before the stop gave it back; then it goes on.
    const std::vector<std::string> then =
        telling({rig.executed.begin() + static_cast<std::ptrdiff_t>(before), rig.executed.end()});
    REQUIRE_GT(then.size(), 4);
    CHECK_EQ(then[0], "M900 K0.2");
    CHECK_EQ(then[1], "M900 K0.045");
    CHECK_EQ(first.back(), "M204 S1000");
    const std::string last = first[first.size() - 2];
    CHECK_EQ(then[2], last);
    CHECK_EQ(then[3], last);  // beside the part, and once more where the road goes on
    CHECK_EQ(then.back(), "M204 S1000");
    // In all: what the whole print tells, in order.
    std::vector<std::string> told(first.begin(), first.end() - 1);
    told.insert(told.end(), then.begin() + 4, then.end());
    REQUIRE_EQ(told.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) CHECK_EQ(told[i], whole[i]);
  }
}

TEST_CASE("a stop gives the acceleration back") {
  const PartFolder folder;
  const std::string path = print_test::small_part(folder);
  Rig rig(told_settings(), path);
  rig.control.stop = [&] { return rig.executed.size() > 60 ? 1 : 0; };
  const host::PrintOutcome outcome = rig.print();
  CHECK_EQ(outcome.exit_code, host::kExitStopped);
  REQUIRE_GT(rig.executed.size(), 3);
  CHECK_EQ(rig.executed[rig.executed.size() - 2], "M107");
  CHECK_EQ(rig.executed.back(), "M204 S1000");
}
