#include "host/printing/link_account.h"

#include <algorithm>
#include <chrono>

#include "host/printing/command_history.h"  // kPlannerBlocksMax

namespace host {

LinkAccount account_of(const firmware_link::Session& session, int feed_percent) {
  LinkAccount account;
  account.accepted = session.accepted();
  account.line = session.accepted_line();
  std::int64_t commands = account.accepted;
  while (account.lines_more < kJournalLinesMax) {
    const auto through = session.commands_through_line(account.line + account.lines_more + 1);
    if (!through) break;
    const bool is_command = *through > commands;
    account.line_kinds |= (is_command ? std::uint32_t{1} : 0) << account.lines_more;
    ++account.lines_more;
    commands = *through;
  }
  const std::int32_t told_free = session.capabilities().planner_blocks;
  account.planner_blocks = std::clamp(static_cast<std::size_t>(std::max(told_free, 0)) + 1,
                                      firmware_link::kPlannerBlocks, kPlannerBlocksMax);
  const std::chrono::duration<double> planned = session.rules().planned_time_max;
  account.planned_s = planned.count() * std::max(1.0, feed_percent / 100.0);
  return account;
}

}  // namespace host
