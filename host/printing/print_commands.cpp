#include "host/printing/print_commands.h"

#include <utility>

#include "core/check.h"

namespace host {

const QueuedCommand* PrintCommands::peek() {
  if (next_ < history_.end()) return &history_.at(next_);
  if (!waiting_) waiting_ = queue_.try_pop();
  return waiting_ ? &*waiting_ : nullptr;
}

void PrintCommands::advance() {
  if (next_ == history_.end()) history_.push(*std::exchange(waiting_, std::nullopt));
  ++next_;
}

void PrintCommands::take() {
  const QueuedCommand* queued = peek();
  RIND_CHECK(queued != nullptr);
  if (queued->lays_road && first_road_ == 0) first_road_ = next_ + 1;
  last_ = *queued;
  advance();
}

void PrintCommands::skip() {
  const QueuedCommand* queued = peek();
  RIND_CHECK(queued != nullptr && next_was_executed());
  last_ = *queued;
  advance();
}

bool PrintCommands::fill_history(std::int64_t number) {
  while (next_ < number) {
    if (peek() == nullptr) return queue_.drained() && !queue_.closed();
    advance();
  }
  return true;
}

void PrintCommands::start_at(std::int64_t first, const MachineState& before, HistoryMark mark) {
  history_.start_at(first, before, std::move(mark));
  next_ = first;
}

void PrintCommands::resume(std::int64_t next, std::int64_t first) {
  next_ = next;
  session_first_ = first;
}

}  // namespace host
