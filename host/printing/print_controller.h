// Runs the link of a print: its order, and its state.
//
//     queue ──> PrintCommands ──> PrinterLink ──step──> port
//                 │                 │
//                 │                 ├─ lost, reset ──> waits, then PrintRecovery: resume point
//                 │                 └─ other fault ──> PrintEnding: safe sequence, as far as heard
//                 ├─ PauseControl, UnderrunWatch: off the part and back
//                 ├─ JournalWriter: before bytes leave          StatusReports: what people are told
//                 └─ a stop, geometry gave up ──> PrintEnding: safe sequence ──> confirmed, or M112
//
// Each turn of run() asks in this order: is a stop wanted, what does the user want, does geometry
// keep up, what is given next, what goes into the journal, what does the controller answer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "firmware_link/ports/byte_port.h"  // BytePort
#include "firmware_link/wire/instant.h"     // Instant
#include "host/pipeline/print_settings.h"   // PrintSettings
#include "host/printing/feed_override.h"    // FeedOverride
#include "host/printing/geometry_thread.h"  // GeometryThread
#include "host/printing/journal_writer.h"   // JournalWriter
#include "host/printing/machine_space.h"    // MachineSpace
#include "host/printing/pause_control.h"    // PauseControl
#include "host/printing/print_commands.h"   // PrintCommands
#include "host/printing/print_control.h"    // PrintControl
#include "host/printing/print_ending.h"     // PrintEnding, LinkOutcome
#include "host/printing/print_recovery.h"   // PrintRecovery, Resumption
#include "host/printing/print_start.h"      // PrintStart, PartExtent
#include "host/printing/printer_link.h"     // PrinterLink
#include "host/printing/progress.h"         // Reporter
#include "host/printing/status_reports.h"   // StatusReports
#include "host/printing/underrun_watch.h"   // UnderrunWatch
#include "host/system/limits.h"             // kPausedHot_s

namespace host {

struct PrintOptions {
  double lost_port_wait_s = 0;  // for a lost port, or a reset controller, to come back; 0: it ends
  double underrun_s = 0;        // with nothing to lay: off the part; 0: never
  double hot_s = kPausedHot_s;  // how long a paused nozzle stays hot
  double banner_wait_s = 2.5;   // for a `start` (SessionOptions)
  bool count_filament = true;   // likewise
  std::optional<double> spool_left_mm = std::nullopt;  // nothing: nobody has said so
  std::optional<MachineSpace> space = std::nullopt;    // nothing: as the settings say
  std::optional<Resumption> resumption = std::nullopt;
};

class PrintController {
 public:
  // What it prints with. All outlive it.
  struct Parts {
    firmware_link::BytePort& port;
    GeometryThread& geometry;
    PrintControl& control;
    Reporter& reporter;
  };
  // `started_s`: steady_seconds() when the program started.
  PrintController(const PrintSettings& settings, const PrintOptions& options,
                  const PartExtent& part, const Parts& parts, double started_s);

  // To the end, whichever it is. Waits for the port a few milliseconds at a time.
  [[nodiscard]] LinkOutcome run();

  // After run() threw: halts the controller (M112), past the session.
  [[nodiscard]] LinkOutcome emergency(const std::string& reason) {
    return ending_.emergency(reason);
  }

  [[nodiscard]] const LinkStatistics& statistics() const { return reports_.statistics(); }

 private:
  [[nodiscard]] firmware_link::Session& session() { return link_.session(); }
  [[nodiscard]] bool stop_asked() { return control_.stop_urgency() > 0 || stop_requested_; }

  // What is given.
  [[nodiscard]] bool started(firmware_link::Instant now);
  void feed(firmware_link::Instant now);
  [[nodiscard]] bool feed_one(firmware_link::Instant now);
  [[nodiscard]] bool give_next(firmware_link::Instant now);
  void take(const QueuedCommand& queued, firmware_link::Instant now);
  void note_percents(const firmware_link::Effect& effect, firmware_link::Instant now);
  void keep_journal();

  // What people want, and whether geometry keeps up.
  void take_requests(firmware_link::Instant now);
  void obey(UserRequest request, firmware_link::Instant now);
  void cancel_object(int number);
  void pause(bool wanted);
  void note_phase(firmware_link::Instant now);
  void hear_events();
  void watch_underrun(firmware_link::Instant now);
  void tell_feed(firmware_link::Instant now);

  // After a lost port or a reset.
  [[nodiscard]] bool recoverable();
  [[nodiscard]] std::optional<LinkOutcome> recover();
  [[nodiscard]] std::optional<LinkOutcome> reconnect(bool reset, double until_s);

  PrintOptions options_;
  GeometryThread& geometry_;
  PrintControl& control_;
  Reporter& reporter_;

  PrinterLink link_;
  PrintCommands commands_;
  PrintStart start_;
  PauseControl pauses_;
  FeedOverride feed_;
  UnderrunWatch underrun_;
  JournalWriter journal_;
  StatusReports reports_;
  PrintRecovery recovery_;
  PrintEnding ending_;

  bool started_ = false;         // the controller has been greeted, and may be used
  bool all_given_ = false;       // the session knows that nothing more comes
  bool unchecked_road_ = false;  // laid since the position was asked for
  bool stop_requested_ = false;
  std::string refused_;  // why it may not start, or not continue; empty: it may
  std::string pause_cause_ = "user";
};

}  // namespace host
