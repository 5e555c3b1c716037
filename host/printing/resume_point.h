// Which command a print goes on with.
//
//     sure ──(in the planner)── accepted ──(in flight)── sent        journal_record.h
//
//     the controller tells its last line     exactly behind that: it lives, and has moved all it
//     has it lives, but numbers nothing          `sent`: what left is read, and runs it was reset
//     under way, or the power   `sure`: the moves in its planner are lost was cut the host died,
//     the machine went on     `sent`: what left was read, and has run since the cable was lost
//     `accepted`: the rest may have been lost with it it was stopped `accepted`
//
// Where the controller does not tell, at most the lines in flight (4) can be laid twice or be
// missing; after a reset also as many moves as the planner's estimate errs by, none where the
// controller tells its blocks (ADVANCED_OK); after a power cut what was printed since the last sync
// (journal.h) is laid twice.
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
