// Which command a print goes on with.
//
//     sure ──(in the planner)── accepted ──(in flight)── sent        journal_record.h
//
// A controller that tells its last line was not reset: it has moved all that it has, and the print
// goes on exactly behind that line; nothing is laid twice. Whatever else may have happened (it was
// reset, its power was cut, the cable was out, rind was killed), what its planner held may be lost,
// and nobody can tell: the print goes on with `sure`, so that no road is missing. Then at most what
// is between `sure` and `sent` is laid twice: the moves that fill a planner (kPlannerBlocks) and
// the lines in flight (kWindowLinesMax); after a power cut also what was printed since the last
// sync (journal.h).
//
// A controller that numbers nothing (Klipper) cannot tell:
//
//     under way            `sent`: what left is read, and runs
//     the cable was lost   `sent`
//     it was stopped       `accepted`
//     it was reset, or the power was cut   `sure`
#pragma once

#include <cstdint>
#include <optional>

#include "host/printing/journal_record.h"  // JournalRecord

namespace host {

struct FoundController {
  std::optional<std::int32_t> line;  // the last one it has; nothing: `start`, or it can't tell
  bool numbers_lines = true;         // its dialect does
  bool same_boot = true;             // this computer has not been off since
};

struct ResumePoint {
  std::int64_t command = 0;
  bool lives = false;  // the controller was not reset: it knows where it is
};

[[nodiscard]] ResumePoint resume_point(const JournalRecord& record, const FoundController& found);

}  // namespace host
