// The print's commands by their number in the print: which one is next, and which were given.
//
//     queue ──> peek() ──take()──> history      after resume() peek() gives what is in the
//                 ▲                  │          history once more, then what is new
//                 └────resume()──────┘
#pragma once

#include <cstdint>
#include <optional>

#include "host/printing/command_history.h"  // CommandHistory
#include "host/printing/machine_state.h"    // MachineState
#include "host/printing/queued_command.h"   // CommandQueue

namespace host {

class PrintCommands {
 public:
  // The queue outlives this.
  explicit PrintCommands(CommandQueue& queue) : queue_(queue) {}

  // The next command; null: there is none at the moment.
  [[nodiscard]] const QueuedCommand* peek();

  // The next command is given to the session. REQUIRES: peek() is not null.
  void take();

  // Whether the next command was executed before this session began to count: it is not given.
  [[nodiscard]] bool next_was_executed() const { return next_ < session_first_; }
  // REQUIRES: likewise, and peek() is not null.
  void skip();

  // Puts commands into the history up to `number`, without giving them. False: geometry has not
  // made all of them yet. True as well when there will be no more.
  [[nodiscard]] bool fill_history(std::int64_t number);

  // Of a resumed print: the queue's first command is number `first`.
  void start_at(std::int64_t first, const MachineState& before, HistoryMark mark);

  // A new session: its first command is number `first`, and all before it were executed. The next
  // command is `next`. REQUIRES: next is in the history, or its end; next <= first.
  void resume(std::int64_t next, std::int64_t first);

  // Roads were laid before this command, by a print that was interrupted.
  void set_first_road(std::int64_t number) { first_road_ = number; }

  // The number of the next command, and of the first one that the session was given.
  [[nodiscard]] std::int64_t next() const { return next_; }
  [[nodiscard]] std::int64_t session_first() const { return session_first_; }

  // 1 + the number of the first command that lays a road; 0: none was given yet.
  [[nodiscard]] std::int64_t first_road() const { return first_road_; }
  [[nodiscard]] bool road_given() const { return first_road_ > 0; }

  // What was given or skipped last.
  [[nodiscard]] const QueuedCommand& last() const { return last_; }

  [[nodiscard]] const CommandHistory& history() const { return history_; }
  // How the machine is set by all before the next command.
  [[nodiscard]] MachineState state() const { return history_.state_before(next_); }

  [[nodiscard]] const CommandQueue& queue() const { return queue_; }
  // Nothing more comes, and all that came was taken.
  [[nodiscard]] bool ended() { return peek() == nullptr && queue_.drained() && !queue_.closed(); }

 private:
  void advance();

  CommandQueue& queue_;
  CommandHistory history_;
  std::optional<QueuedCommand> waiting_;  // popped, not in the history
  QueuedCommand last_;
  std::int64_t next_ = 0;
  std::int64_t session_first_ = 0;
  std::int64_t first_road_ = 0;
};

}  // namespace host
