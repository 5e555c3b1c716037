// Which of the last lines a controller that numbers nothing has taken (Klipper): it reads in order,
// and tells where it was commanded to last.
//
//     accepted ──line──line──line──line── sent
//        P0       P1    P2    P3    P4            it is at P2: two were taken
//
// Where several places are alike (filament alone, a fan), the first is meant: what may not have run
// is done again, so that nothing is missing.
//
//     homed, at one of these places     behind that one
//     not homed, at one of them         likewise, and it must be told its height: it stood idle for
//                                       long and let its motors go
//     homed, off the part               `accepted`: it was parked, or stopped
//     anywhere else                     `sure`: it was restarted, which its planner does not
//     survive
#pragma once

#include <cstdint>
#include <functional>

#include "firmware_link/wire/reply.h"    // Position
#include "host/printing/resume_point.h"  // ResumePoint

namespace host {

struct ReportedPosition {
  firmware_link::Position place;
  bool homed = true;  // it knows that it is there
};

// How many commands of the print were accepted or on their way.
[[nodiscard]] std::int64_t commands_sent(const JournalRecord& record);

// `before`: how the machine is set before a command; asked for record.accepted … `last`.
// REQUIRES: record.accepted <= last.
[[nodiscard]] ResumePoint resume_point_at(const JournalRecord& record, const ReportedPosition& told,
                                          std::int64_t last,
                                          const std::function<MachineState(std::int64_t)>& before);

}  // namespace host
