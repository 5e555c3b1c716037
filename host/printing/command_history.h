// The last commands of the print that were given to the controller, by their number in the print:
// what is given again when lines were lost, and how the machine was set before any of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "core/check.h"                    // RIND_CHECK
#include "firmware_link/wire/limits.h"     // kHistoryLinesMax
#include "host/printing/machine_state.h"   // MachineState
#include "host/printing/queued_command.h"  // QueuedCommand

namespace host {

// The deepest planner that is expected: RepRapFirmware's has 40 to 60 moves.
inline constexpr std::size_t kPlannerBlocksMax = 64;

// More than can be in doubt: the session's lines, and the moves in the planner with commands of
// other kinds among them.
inline constexpr std::size_t kHistoryCommandsMax = 512;
static_assert(kHistoryCommandsMax >= 2 * (firmware_link::kHistoryLinesMax + kPlannerBlocksMax));

// A shorter move may get no block of its own: Marlin adds moves of less than 6 steps to the next.
inline constexpr std::int64_t kBlockLengthUm = 200;

// The least number of blocks that the command takes in a planner, from how the machine was set
// before it. kAllBlocks: it lets the planner run empty before it is accepted.
inline constexpr std::size_t kAllBlocks = ~std::size_t{0};
[[nodiscard]] std::size_t blocks_at_least(const firmware_link::Command& command,
                                          const MachineState& before);

// What a journal keeps of all commands before one: the layer of the last of them, and the hash of
// their texts (checkpoint.h).
struct HistoryMark {
  std::shared_ptr<const Checkpoint> checkpoint;  // null: before the first layer
  std::uint64_t hash = kHashStart;
};

class CommandHistory {
 public:
  // Nothing is known of what was before command `first` but how the machine was set.
  void start_at(std::int64_t first, const MachineState& before, HistoryMark mark) {
    begin_ = end_ = first;
    before_ = before;
    mark_ = std::move(mark);
  }

  void push(QueuedCommand command) {
    if (end_ - begin_ == static_cast<std::int64_t>(kHistoryCommandsMax)) {
      const QueuedCommand& oldest = at(begin_);
      before_.apply(oldest.command);
      mark_ = {oldest.checkpoint, oldest.hash};
      ++begin_;
    }
    slot(end_++) = std::move(command);
  }

  [[nodiscard]] std::int64_t begin() const { return begin_; }
  [[nodiscard]] std::int64_t end() const { return end_; }

  // REQUIRES: begin() <= number < end()
  [[nodiscard]] const QueuedCommand& at(std::int64_t number) const {
    RIND_CHECK(number >= begin_ && number < end_);
    return commands_[static_cast<std::size_t>(number) % kHistoryCommandsMax];
  }

  // REQUIRES: begin() <= number <= end()
  [[nodiscard]] MachineState state_before(std::int64_t number) const {
    RIND_CHECK(number >= begin_ && number <= end_);
    MachineState state = before_;
    for (std::int64_t i = begin_; i < number; ++i) state.apply(at(i).command);
    return state;
  }

  // REQUIRES: begin() <= number <= end()
  [[nodiscard]] HistoryMark mark_before(std::int64_t number) const {
    if (number == begin_) return mark_;
    const QueuedCommand& last = at(number - 1);
    return {last.checkpoint, last.hash};
  }

  // A planner of so many blocks has accepted all commands before `number`. All before the command
  // that is returned were executed then; the planner may still hold the others. Nothing: the answer
  // is farther back than the history. REQUIRES: begin() <= number <= end()
  [[nodiscard]] std::optional<std::int64_t> executed_before(std::int64_t number,
                                                            std::size_t blocks) const;

  // The same for a controller that plans by time, of which it may still hold so many seconds of
  // motion at full speed.
  [[nodiscard]] std::optional<std::int64_t> executed_before(std::int64_t number,
                                                            double seconds) const;

  // The height that the commands before `number` have sent the nozzle to; 0: none has.
  // REQUIRES: begin() <= number <= end()
  [[nodiscard]] std::int64_t last_z_um(std::int64_t number) const;

 private:
  [[nodiscard]] QueuedCommand& slot(std::int64_t number) {
    return commands_[static_cast<std::size_t>(number) % kHistoryCommandsMax];
  }

  std::array<QueuedCommand, kHistoryCommandsMax> commands_;
  std::int64_t begin_ = 0;
  std::int64_t end_ = 0;
  MachineState before_;  // begin_
  HistoryMark mark_;     // likewise
};

}  // namespace host
