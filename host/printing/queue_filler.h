// Puts the pipeline's commands into the queue, each with its place in the print. Of a print that is
// gone on with, drops those that were executed, having seen that they are the same ones.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/motions/motion.h"           // Motion
#include "core/settings.h"                 // Settings
#include "firmware_link/wire/command.h"    // Command
#include "host/pipeline/checkpoint.h"      // Checkpoint
#include "host/printing/journal_record.h"  // JournalRecord
#include "host/printing/queued_command.h"  // CommandQueue

namespace host {

class QueueFiller {
 public:
  // `resumed`: the record that the print is gone on from; null: from the begin. Both outlive it.
  QueueFiller(CommandQueue& queue, const core::Settings& settings, const JournalRecord* resumed);

  void start_layer(const Checkpoint& checkpoint);
  // Before the next command.
  void pause(const std::string& why) { next_.pause = std::make_shared<const std::string>(why); }

  // False when the queue was closed, or error() says why.
  [[nodiscard]] bool take(const core::Motion& motion,
                          const std::optional<firmware_link::Command>& command);

  // The pipeline came to its end. False: error() says why.
  [[nodiscard]] bool finish();

  [[nodiscard]] const std::optional<std::string>& error() const { return error_; }

  // Of motion at full speed, from the begin to what was queued last. For other threads too.
  [[nodiscard]] double seconds_made() const { return seconds_made_.load(); }

 private:
  void note(const core::Motion& motion);
  void add_way(core::Point to, double speed_mm_s);

  CommandQueue& queue_;
  QueuedCommand next_;
  std::int64_t number_ = 0;               // of the next command in the print
  std::uint64_t last_hash_ = kHashBegin;  // of the one before it
  std::optional<core::Point> position_;
  std::atomic<double> seconds_made_ = 0;

  const JournalRecord* resumed_;
  MachineState machine_;  // before the next command, while some are dropped
  std::optional<std::string> error_;
};

}  // namespace host
