#include "host/printing/status_reports.h"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "firmware_link/dialects/marlin_dialect.h"
#include "host/files/log_file.h"
#include "tests/support/temporary_folder.h"

using firmware_link::SessionEvent;

namespace {

// Reports into a log.
struct Bench {
  Bench() {
    auto log = host::LogFile::open(folder.path("rind.log"));
    REQUIRE(log.ok());
    reporter.log_to(std::move(log).value());
  }

  test::TemporaryFolder folder;
  host::Reporter reporter{{.quiet = true, .json = false, .stdout_taken = false}};
  host::CommandQueue queue{{100, 1'000'000}};
  host::PrintCommands commands{queue};
  host::PipelineSignals signals;
  host::StatusReports reports{0, commands, signals, reporter};
  firmware_link::Session session{std::make_unique<firmware_link::MarlinDialect>(), {}, {}};

  [[nodiscard]] std::string told() const {
    std::ifstream file(folder.path("rind.log"));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  [[nodiscard]] bool says(const std::string& text) const {
    return told().find(text) != std::string::npos;
  }
  void tell(SessionEvent::Kind kind, const std::string& text, bool greeted) {
    reports.tell_event({kind, text}, session, greeted);
  }
};

}  // namespace

TEST_CASE("the counts of lost sessions are added to those of the session at hand") {
  Bench bench;
  firmware_link::SessionStatistics link;
  link.commands_acknowledged = 10;
  link.resends = 2;
  link.stalls = 1;
  bench.reports.note_counts(link);
  bench.reports.start_session();
  link.commands_acknowledged = 5;
  bench.reports.note_counts(link);
  CHECK_EQ(bench.reports.statistics().commands, 15);
  CHECK_EQ(bench.reports.statistics().resends, 4);
  CHECK_EQ(bench.reports.statistics().stalls, 2);
  CHECK(bench.reports.statistics().first_command_s.has_value());
  CHECK_FALSE(bench.reports.statistics().first_road_s.has_value());
}

TEST_CASE("a controller that does not know our own question is not reported for it") {
  Bench bench;
  bench.tell(SessionEvent::Kind::kWarning, "Unknown command: \"M211\"", false);
  CHECK_FALSE(bench.says("M211"));
  bench.tell(SessionEvent::Kind::kWarning, "Unknown command: \"M999\"", false);
  CHECK(bench.says("M999"));
  bench.tell(SessionEvent::Kind::kWarning, "Unknown command: \"M211\"", true);  // the user's own
  CHECK(bench.says("M211"));
}

TEST_CASE("actions that are for people are told to them, others are not") {
  Bench bench;
  bench.tell(SessionEvent::Kind::kAction, "prompt_begin Change the filament", true);
  CHECK(bench.says("on its display: Change the filament"));
  bench.tell(SessionEvent::Kind::kAction, "notification whatever", true);
  CHECK_FALSE(bench.says("whatever"));
}

TEST_CASE("warnings of the geometry are told at once") {
  Bench bench;
  bench.signals.warnings.put("a thin wall");
  bench.reports.show_progress(bench.session);
  CHECK(bench.says("warning: a thin wall"));
}
