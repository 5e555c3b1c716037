// With which command a print resumes on a controller that numbers no lines, but reports the
// position to which it was commanded last (Klipper). It reads lines in order, so the position tells
// how many of the lines in flight it has executed:
//
//     accepted ──line──line──line──line── sent
//        P0       P1    P2    P3    P4            it reports P2: two lines were executed
//
// Several of these positions may be equal, because a line moved only filament, or set a fan. Then
// the first of them counts: a line that may not have been executed is executed again.
//
//     it reports                          the print resumes with
//     ─────────────────────────────────────────────────────────────────────────────────────
//     one of these positions, homed       the command after that line
//     one of them, not homed              the same, and it must be told its height: it was idle
//                                         for long, and has switched its motors off
//     another one, homed, and the print
//     was parked                          `accepted`
//     anything else                       `sure`: it was restarted, and its planner is lost
//
// A print that was stopped resumes with `accepted`, one that was reset with `sure`.
#pragma once

#include <cstdint>
#include <functional>

#include "firmware_link/wire/reply.h"    // Position
#include "host/printing/resume_point.h"  // ResumePoint

namespace host {

struct ReportedPosition {
  firmware_link::Position position;
  bool homed = true;  // the controller knows that it is there
};

// How many commands of the print were accepted or in flight.
[[nodiscard]] std::int64_t commands_sent(const JournalRecord& record);

// `before`: the machine before a command; asked for record.accepted … `last`.
// REQUIRES: record.accepted <= last.
[[nodiscard]] ResumePoint resume_point_at(const JournalRecord& record, const ReportedPosition& told,
                                          std::int64_t last,
                                          const std::function<MachineState(std::int64_t)>& before);

}  // namespace host
