#include "host/printing/resume_point.h"

#include <doctest/doctest.h>

#include <optional>
#include <utility>
#include <vector>

TEST_CASE("with which command a print resumes") {
  using host::PrintState;
  host::JournalRecord record;
  record.sure = 90;
  record.accepted = 100;
  record.line = 130;
  record.lines_more = 4;
  record.line_kinds = 0b1011;  // the third is the link's own
  const auto at = [&](PrintState state, host::FoundController found) {
    record.state = state;
    return host::resume_point(record, found);
  };
  // The controller's own account, in any state.
  for (int state = 0; state < 5; ++state) {
    for (const auto& [line, command] : std::vector<std::pair<int, int>>{
             {130, 100}, {131, 101}, {132, 102}, {133, 102}, {134, 103}}) {
      const auto point = at(static_cast<PrintState>(state), {line, true, false});
      CHECK_EQ(point.command, command);
      CHECK(point.position_known);
    }
  }
  for (const std::optional<std::int32_t> line :
       {std::optional<std::int32_t>(), std::optional<std::int32_t>(0),
        std::optional<std::int32_t>(129), std::optional<std::int32_t>(135)}) {
    // Whoever can't tell may have lost what its planner held.
    for (int state = 0; state < 5; ++state) {
      for (const bool same_boot : {false, true}) {
        const auto point = at(static_cast<PrintState>(state), {line, true, same_boot});
        CHECK_EQ(point.command, 90);
        CHECK_FALSE(point.position_known);
      }
    }
  }
  // One that numbers nothing.
  CHECK_EQ(at(PrintState::kRunning, {{}, false, true}).command, 103);
  CHECK(at(PrintState::kRunning, {{}, false, true}).position_known);
  CHECK_EQ(at(PrintState::kPortLost, {{}, false, true}).command, 103);
  CHECK_EQ(at(PrintState::kLinkFault, {{}, false, true}).command, 103);
  CHECK_EQ(at(PrintState::kStopped, {{}, false, true}).command, 100);
  CHECK_EQ(at(PrintState::kReset, {{}, false, true}).command, 90);
  CHECK_EQ(at(PrintState::kRunning, {{}, false, false}).command, 90);
  CHECK_FALSE(at(PrintState::kRunning, {{}, false, false}).position_known);
}
