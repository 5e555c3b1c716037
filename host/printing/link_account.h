// What a session tells of the commands that it took: what a journal's record needs of it.
#pragma once

#include <cstdint>

#include "firmware_link/session/session.h"  // Session
#include "host/printing/journal_record.h"   // kJournalLinesMax

namespace host {

struct LinkAccount {
  std::int64_t accepted = 0;       // commands of the print, by this session
  std::int32_t line = 0;           // the number of the last accepted line
  std::int32_t lines_more = 0;     // sent, or about to be, behind it; at most kJournalLinesMax
  std::uint32_t line_kinds = 0;    // bit i: the i-th of these is a command of the print
  std::size_t planner_blocks = 0;  // that the planner may hold
  double planned_s = 0;            // of motion at full speed that it may hold; 0: it counts blocks
};

// `feed_percent`: at which it runs.
[[nodiscard]] LinkAccount account_of(const firmware_link::Session& session, int feed_percent);

}  // namespace host
