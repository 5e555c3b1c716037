// Ready G-code printed as it is: the same commands, byte for byte; pauses that bring the file's own
// modes back; damage on the wire.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host/system/exit_codes.h"
#include "tests/host/interrupted_print.h"
#include "tests/support/gcode_machine.h"
#include "tests/support/temporary_folder.h"

using firmware_link::VirtualDialect;
using print_test::coarse;
using print_test::Rig;
using test::PartFolder;

namespace {

std::vector<std::string> without_own(std::vector<std::string> lines) {
  std::erase_if(lines, [](const std::string& line) { return test::is_own_line(line); });
  return lines;
}

// Spelled in ways that rind itself never does.
std::vector<std::string> other_spelling(std::vector<std::string> lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t at = lines[i].find(" E0.");
    if (at != std::string::npos && i % 2 == 0) lines[i].erase(at + 2, 1);
    if (lines[i].starts_with("G1 X") && i % 3 == 0) lines[i].insert(4, "+");
  }
  return lines;
}

struct Files {
  PartFolder folder;
  std::vector<std::string> relative =
      other_spelling(print_test::sliced_lines(coarse(), print_test::small_part(folder)));
  std::vector<std::string> absolute = print_test::with_absolute_filament(relative);
};

// Net filament pushed while x or y moved, and where: as a controller with all modes would.
double laid_mm(const std::vector<std::string>& lines) {
  test::GcodeMachine machine;
  for (const std::string& line : lines) machine.run(line);
  return machine.filament_mm;
}

}  // namespace

TEST_CASE("each command is sent in its own words") {
  const Files files;
  for (const auto dialect : {VirtualDialect::kMarlin, VirtualDialect::kRepRap}) {
    for (const std::vector<std::string>* lines : {&files.relative, &files.absolute}) {
      for (const char* end : {"\n", "\r\n", "\r"}) {
        // RepRapFirmware takes its time between two hosts.
        if (dialect == VirtualDialect::kRepRap && *end == '\r') continue;
        firmware_link::VirtualControllerOptions machine;
        machine.dialect = dialect;
        const std::string path =
            files.folder.add_text("part.gcode", print_test::dressed(*lines, end));
        Rig rig(coarse(), path, machine);
        const host::PrintOutcome outcome = rig.print();
        CAPTURE(outcome.message);
        REQUIRE_EQ(outcome.exit_code, host::kExitDone);
        CHECK_EQ(rig.sent, without_own(*lines));
        CHECK_EQ(outcome.geometry.layers, 13);
      }
    }
  }
}

TEST_CASE("a pause leaves the part, and brings the file's modes back") {
  const Files files;
  for (const std::vector<std::string>* lines : {&files.relative, &files.absolute}) {
    const std::string path = files.folder.add_text("part.gcode", print_test::dressed(*lines, "\n"));
    for (const std::size_t at : {150U, 260U, 377U}) {
      Rig rig(coarse(), path);
      bool paused = false, resumed = false;
      rig.control.request = [&]() -> std::optional<host::UserRequest> {
        if (!paused && rig.sent.size() > at) {
          paused = true;
          return host::UserRequest::kPause;
        }
        // It is parked once it stands far from the part.
        if (paused && !resumed && rig.controller().z_mm > 9) {
          resumed = true;
          return host::UserRequest::kResume;
        }
        return std::nullopt;
      };
      REQUIRE_EQ(rig.print().exit_code, host::kExitDone);
      CHECK(resumed);
      CHECK_EQ(laid_mm(rig.executed), doctest::Approx(laid_mm(without_own(*lines))).epsilon(1e-9));
      // All of the file's commands are there, in order; between them are rind's own.
      std::size_t next = 0;
      const std::vector<std::string> wanted = without_own(*lines);
      for (const std::string& line : rig.sent) {
        if (next < wanted.size() && line == wanted[next]) ++next;
      }
      CHECK_EQ(next, wanted.size());
      CHECK_GT(rig.sent.size(), wanted.size() + 5);
    }
  }
}

TEST_CASE("the file's factors are not lost, and the user's come on top") {
  const Files files;
  std::vector<std::string> lines = files.relative;
  lines.insert(lines.begin() + 40, {"M220 S80", "M221 S90"});
  lines.insert(lines.begin() + 200, "M220 S50");
  const std::string path = files.folder.add_text("part.gcode", print_test::dressed(lines, "\n"));
  Rig rig(coarse(), path);
  int asked = 0;
  rig.control.request = [&]() -> std::optional<host::UserRequest> {
    if (rig.sent.size() < 100 || asked == 2) return std::nullopt;
    return asked++ == 0 ? host::UserRequest::kFeedUp : host::UserRequest::kFlowUp;
  };
  REQUIRE_EQ(rig.print().exit_code, host::kExitDone);
  std::vector<std::string> factors;
  for (const std::string& line : rig.sent) {
    if (line.starts_with("M220") || line.starts_with("M221")) factors.push_back(line);
  }
  CHECK_EQ(factors, std::vector<std::string>{"M220 S80", "M221 S90", "M220 S88", "M221 S99",
                                             "M220 S50", "M220 S55"});
}

TEST_CASE("a stop puts modes and factors right before it moves") {
  const Files files;
  std::vector<std::string> lines = files.absolute;
  lines.insert(lines.begin() + 40, "M220 S80");
  const std::string path = files.folder.add_text("part.gcode", print_test::dressed(lines, "\n"));
  Rig rig(coarse(), path);
  rig.control.stop = [&] { return rig.sent.size() > 200 ? 1 : 0; };
  CHECK_EQ(rig.print().exit_code, host::kExitStopped);
  const auto find = [&](const std::string& line) {
    return std::find(rig.sent.begin() + 200, rig.sent.end(), line) - rig.sent.begin();
  };
  const auto end = static_cast<std::ptrdiff_t>(rig.sent.size());
  CHECK_LT(find("M83"), find("G1E-1F2400") == end ? find("G1 E-1F2400") : find("G1E-1F2400"));
  CHECK_LT(find("M220 S100"), end);
  CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
}

TEST_CASE("a file that is changed while it is printed ends the print safely") {
  const Files files;
  std::vector<std::string> lines = files.relative;
  // Longer than one piece, and than the queue.
  while (lines.size() < 8'000)
    lines.insert(lines.end() - 20, files.relative.begin() + 100, files.relative.begin() + 300);
  const std::string path = files.folder.add_text("part.gcode", print_test::dressed(lines, "\n"));
  Rig rig(coarse(), path);
  bool changed = false;
  rig.on_executed = [&] {
    if (changed || rig.sent.size() < 500) return;
    changed = true;
    (void)files.folder.add_text("part.gcode", "G28\nM500\n");
  };
  const host::PrintOutcome outcome = rig.print();
  CHECK_EQ(outcome.exit_code, host::kExitBadInput);
  CHECK_NE(outcome.message.find("changed while it was read"), std::string::npos);
  CHECK_EQ(rig.controller().nozzle_target_celsius, 0);
}

TEST_CASE("another file is not resumed") {
  const Files files;
  const test::TemporaryFolder folder;
  const std::string path =
      files.folder.add_text("part.gcode", print_test::dressed(files.absolute, "\n"));
  Rig rig(coarse(), path);
  core::Result<host::Journal> journal = print_test::new_journal(folder.path("j"));
  REQUIRE(journal.ok());
  rig.control.kept_journal = &journal.value();
  rig.control.stop = [&] { return rig.sent.size() > 200 ? 1 : 0; };
  CHECK_EQ(rig.print().exit_code, host::kExitStopped);
  std::vector<std::string> other = files.absolute;
  std::swap(other[120], other[121]);
  (void)files.folder.add_text("part.gcode", print_test::dressed(other, "\n"));
  { const host::Journal closed = std::move(journal).value(); }
  const host::PrintOutcome outcome = print_test::print_rest(rig, path, folder.path("j"));
  CHECK_EQ(outcome.exit_code, host::kExitBadInput);
  CHECK_NE(outcome.message.find("its commands differ"), std::string::npos);
}
