// The last commands of the print that were given to the controller, by their number in the print:
// what is given again when lines were lost, and how the machine was set before any of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>

#include "core/check.h"                    // RIND_CHECK
#include "firmware_link/limits.h"          // kHistoryLinesMax, kPlannerBlocks
#include "firmware_link/planner_watch.h"   // planner_blocks_of
#include "host/printing/machine_state.h"   // MachineState
#include "host/printing/queued_command.h"  // QueuedCommand

namespace host {

// More than can be in doubt: the session's lines, and the moves in the planner with commands of
// other kinds among them.
inline constexpr std::size_t kTrailCommandsMax = 128;
static_assert(kTrailCommandsMax >=
              2 * (firmware_link::kHistoryLinesMax + firmware_link::kPlannerBlocks));

class CommandTrail {
 public:
  // Nothing is known of what was before command `first` but how the machine was set.
  void begin_at(std::int64_t first, const MachineState& before) {
    begin_ = end_ = first;
    before_ = before;
  }

  void push(QueuedCommand command) {
    if (end_ - begin_ == static_cast<std::int64_t>(kTrailCommandsMax)) {
      before_.apply(at(begin_).command);
      ++begin_;
    }
    place(end_++) = std::move(command);
  }

  [[nodiscard]] std::int64_t begin() const { return begin_; }
  [[nodiscard]] std::int64_t end() const { return end_; }

  // REQUIRES: begin() <= number < end()
  [[nodiscard]] const QueuedCommand& at(std::int64_t number) const {
    RIND_CHECK(number >= begin_ && number < end_);
    return commands_[static_cast<std::size_t>(number) % kTrailCommandsMax];
  }

  // REQUIRES: begin() <= number <= end()
  [[nodiscard]] MachineState state_before(std::int64_t number) const {
    RIND_CHECK(number >= begin_ && number <= end_);
    MachineState state = before_;
    for (std::int64_t i = begin_; i < number; ++i) state.apply(at(i).command);
    return state;
  }

  // The number of the first of the last moves before `number` that take so many blocks of the
  // planner; begin() when there are fewer.
  [[nodiscard]] std::int64_t blocks_back(std::int64_t number, std::size_t blocks) const {
    while (blocks > 0 && number > begin_) {
      const auto* move = std::get_if<firmware_link::Move>(&at(--number).command);
      if (move == nullptr) continue;
      blocks -= std::min(blocks, firmware_link::planner_blocks_of(*move));
    }
    return number;
  }

 private:
  [[nodiscard]] QueuedCommand& place(std::int64_t number) {
    return commands_[static_cast<std::size_t>(number) % kTrailCommandsMax];
  }

  std::array<QueuedCommand, kTrailCommandsMax> commands_;
  std::int64_t begin_ = 0;
  std::int64_t end_ = 0;
  MachineState before_;  // begin_
};

}  // namespace host
