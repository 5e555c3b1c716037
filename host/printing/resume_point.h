// With which command a print resumes.
//
//     ──── moved ────┬──── in the planner ────┬──── in flight ────┬── not sent ──
//                  sure                   accepted              sent        journal_record.h
//
//     what is found                                     resumes with        laid twice, at most
//     ───────────────────────────────────────────────────────────────────────────────────────────
//     the controller tells its last line, and the
//     journal knows that line                           after that line     nothing
//
//     a controller that numbers lines tells another
//     one, or none: it was reset, or had no power       `sure`              planner, in flight
//
//     a controller that numbers nothing (Klipper):
//     the print was running, and this computer was
//     not restarted; port lost; link fault              `sent`              nothing
//     the print was stopped                             `accepted`          nothing
//     the controller was reset; the print was running,
//     and this computer was restarted                   `sure`              planner, in flight
//
// A controller that tells its last line was not reset: its planner empties by itself, so everything
// up to that line moves. In all other cases the planner's moves may be lost, and nobody can tell.
// The print resumes with `sure` then, so that no road is missing. A planner holds kPlannerBlocks
// moves, and kWindowLinesMax lines are in flight. After a power cut, what was printed since the
// last sync is laid twice, too (journal.h).
//
// The controller still knows the nozzle's position in the first row, and where `sent` is chosen. A
// Klipper that reports its position is treated by that: reported_position.h.
#pragma once

#include <cstdint>
#include <optional>

#include "host/printing/journal_record.h"  // JournalRecord

namespace host {

// What is known of the controller when it is found again.
struct FoundController {
  std::optional<std::int32_t> line;  // its last one; nothing: it was reset, or can't tell
  bool numbers_lines = true;         // its dialect does
  bool same_boot = true;             // this computer was not restarted since the record
};

struct ResumePoint {
  std::int64_t command = 0;     // its number in the print
  bool position_known = false;  // the controller was not reset: it knows where the nozzle is
};

[[nodiscard]] ResumePoint resume_point(const JournalRecord& record, const FoundController& found);

}  // namespace host
