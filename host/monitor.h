// Runs the link: takes commands from the queue, feeds the session, watches for whatever must end
// the print, and brings it to a safe end then.
//
//     queue ──try_pop──> session ──step──> port
//               ▲           │
//               │           └─ fault ──> safe sequence, as far as the controller still listens
//               └─ signal, geometry gave up ──> safe sequence ──> acknowledged, or M112
//
// Safe sequence: filament drawn back, nozzle lifted off the part, heaters off, fan off. What of it
// is possible depends on what was done so far: nothing is lifted before a height is known.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/settings.h"            // Settings
#include "core/units.h"               // LayerIndex, Length
#include "firmware_link/byte_port.h"  // BytePort
#include "firmware_link/command.h"    // Command
#include "firmware_link/session.h"    // Session
#include "host/bounded_queue.h"       // BoundedQueue
#include "host/progress.h"            // Reporter
#include "host/statistics.h"          // LinkStatistics

namespace host {

// A command, and what a person wants to know of where it belongs.
struct QueuedCommand {
  firmware_link::Command command;
  core::LayerIndex layer = 0;  // counted from 1; 0: before the first
  core::Length top;            // of the layer
  bool lays_road = false;
  double filament_mm = 0;  // in roads, from the begin to here
};

using CommandQueue = BoundedQueue<QueuedCommand>;

enum class LinkEnd {
  kDone,           // the controller has acknowledged all
  kUserStopped,    // by the first signal
  kUserHalted,     // by the second: M112
  kGeometryEnded,  // the filling side closed the queue
  kFaulted,        // link lost, or the controller gave up
};

struct LinkOutcome {
  LinkEnd end = LinkEnd::kDone;
  std::string reason;          // of a fault
  core::LayerIndex layer = 0;  // where it ended; 0: no road was sent
  core::Length height;
  std::string measures;  // "nozzle lifted, heaters off"; empty when there was nothing to do
};

struct MonitorOptions {
  double began_s = 0;               // steady_seconds() when the program began
  std::function<int()> stop_count;  // signals so far
  std::function<std::int64_t()> slices_cut;
  std::function<core::LayerIndex()> layers;            // of the part; 0: not known yet
  std::function<std::vector<std::string>()> warnings;  // since it was asked last
};

class Monitor {
 public:
  // REQUIRES: all outlive the monitor; all functions set.
  Monitor(const core::Settings& settings, MonitorOptions options, firmware_link::BytePort& port,
          CommandQueue& queue, Reporter& reporter);

  // To the end, whichever it is. Waits for the port a few milliseconds at a time.
  [[nodiscard]] LinkOutcome run();

  // After run() threw: halts the controller (M112), past the session.
  [[nodiscard]] LinkOutcome emergency(const std::string& reason);

  [[nodiscard]] const LinkStatistics& statistics() const { return statistics_; }

 private:
  void feed(firmware_link::Instant now);
  void take(const QueuedCommand& queued, firmware_link::Instant now);
  void note_acknowledged();
  void tell_events();
  void report_progress();
  [[nodiscard]] std::vector<firmware_link::Command> safe_sequence() const;
  [[nodiscard]] LinkOutcome stop(LinkEnd end);
  [[nodiscard]] LinkOutcome halt();
  [[nodiscard]] LinkOutcome faulted();
  [[nodiscard]] LinkOutcome outcome(LinkEnd end) const;
  void flush_output(double limit_s);

  const core::Settings& settings_;
  MonitorOptions options_;
  firmware_link::BytePort& port_;
  CommandQueue& queue_;
  Reporter& reporter_;
  firmware_link::Session session_;
  LinkStatistics statistics_;

  QueuedCommand last_;                    // taken last
  std::optional<QueuedCommand> waiting_;  // popped, not taken
  bool unchecked_road_ = false;           // since the position was asked for
  std::int64_t taken_ = 0;
  std::int64_t first_road_ = 0;  // counts as taken_ does; 0: none yet
  std::int64_t z_um_ = -1;       // told last; -1: unknown
  bool finish_said_ = false;
};

}  // namespace host
