// Puts the pipeline's commands into the queue, each with its layer, filament and time in the print.
// When a print is resumed, drops the commands that were executed already, after checking that their
// hash is the journal's.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/motions/motion.h"           // Motion
#include "core/settings.h"                 // Settings
#include "firmware_link/wire/command.h"    // Command
#include "host/gcode/ready_reader.h"       // ReadyCommand
#include "host/pipeline/checkpoint.h"      // Checkpoint
#include "host/printing/journal_record.h"  // JournalRecord
#include "host/printing/queued_command.h"  // CommandQueue

namespace host {

class QueueFiller {
 public:
  // `resumed`: the record that the print resumes from; null: it starts from its first layer. Both
  // outlive the filler.
  QueueFiller(CommandQueue& queue, const core::Settings& settings, const JournalRecord* resumed);

  void start_layer(const Checkpoint& checkpoint);
  // Before the next command, because of a bad layer.
  void pause(const std::string& why);

  // False when the queue was closed, or error() says why.
  [[nodiscard]] bool take(const core::Motion& motion,
                          const std::optional<firmware_link::Command>& command);

  // Of a ready file: the command, and how the print stands behind it. Its checkpoint has what it
  // sets up.
  [[nodiscard]] bool take_ready(const ReadyCommand& command, const FilePlace& behind);

  // The pipeline came to its end. False: error() says why.
  [[nodiscard]] bool finish();

  [[nodiscard]] const std::optional<std::string>& error() const { return error_; }

  // Of motion at full speed, from the print's start to what was queued last. For any thread.
  // Neither acceleration nor heating is counted: it is a lower bound, unlike core::MotionClock.
  [[nodiscard]] double seconds_made() const { return seconds_made_.load(); }

 private:
  [[nodiscard]] bool put(const firmware_link::Command& command);
  void note(const core::Motion& motion);
  void add_line(core::Point to, double speed_mm_s);

  CommandQueue& queue_;
  QueuedCommand next_;
  std::int64_t number_ = 0;               // of the next command in the print
  std::uint64_t last_hash_ = kHashStart;  // of the one before it
  std::optional<core::Point> position_;
  std::atomic<double> seconds_made_ = 0;

  const JournalRecord* resumed_;
  MachineState machine_;  // before the next command, while some are dropped
  std::optional<std::string> error_;
};

}  // namespace host
