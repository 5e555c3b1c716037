// How a print ends, and how its printer is made safe.
//
//     all acknowledged        done()      the journal goes
//     stopped, or geometry    stop()      safe sequence, waited for; not confirmed: M112
//     the link faults         faulted()   safe sequence, as far as the controller may hear it
//     second Ctrl-C, and an exception     M112, past the session
//
// Safe sequence: filament drawn back, nozzle lifted off the part and parked, heaters off, fan off.
// Nothing is lifted or parked before a height is known.
#pragma once

#include <string>
#include <vector>

#include "core/settings.h"                 // Settings
#include "core/units.h"                    // LayerIndex, Length
#include "firmware_link/wire/command.h"    // Command
#include "host/printing/feed_override.h"   // FeedOverride
#include "host/printing/journal_writer.h"  // JournalWriter
#include "host/printing/pause_control.h"   // PauseControl
#include "host/printing/print_commands.h"  // PrintCommands
#include "host/printing/print_control.h"   // PrintControl
#include "host/printing/print_start.h"     // PrintStart
#include "host/printing/printer_link.h"    // PrinterLink
#include "host/printing/status_reports.h"  // StatusReports

namespace host {

enum class LinkEnd {
  kDone,           // the controller has acknowledged all
  kUserStopped,    // by the first signal, a key, or at the printer
  kUserHalted,     // by the second: M112
  kGeometryEnded,  // the geometry closed the queue
  kRefused,        // by PrintControl::may_start, or the machine's space
  kFaulted,        // link lost, or the controller gave up
};

struct LinkOutcome {
  LinkEnd end = LinkEnd::kDone;
  std::string reason;          // of a fault
  core::LayerIndex layer = 0;  // where it ended; 0: no road was sent
  core::Length height;
  std::string measures;  // "nozzle lifted, heaters off"; empty when there was nothing to do
};

class PrintEnding {
 public:
  // What of a running print its end reads and sets. All outlive it.
  struct Parts {
    PrinterLink& link;
    const PrintCommands& commands;
    const PauseControl& pauses;
    const FeedOverride& feed;
    const PrintStart& start;
    JournalWriter& journal;
    StatusReports& reports;
    PrintControl& control;
  };
  explicit PrintEnding(const Parts& parts) : parts_(parts) {}

  [[nodiscard]] LinkOutcome done();

  // A safe end, waited for. `reason`: of a refusal.
  [[nodiscard]] LinkOutcome stop(LinkEnd end, const std::string& reason = {});

  // The session has faulted.
  [[nodiscard]] LinkOutcome faulted();

  // Nothing was heated or moved yet, and cannot be for this reason.
  [[nodiscard]] LinkOutcome not_resumed(const std::string& reason);

  // The print cannot be resumed while a port or a controller is waited for. The printer may have
  // forgotten its position, so nothing moves.
  [[nodiscard]] LinkOutcome stop_waiting(LinkEnd end);

  // The session is not to be trusted any more: M112 past it.
  [[nodiscard]] LinkOutcome emergency(const std::string& reason);

  // Where the print stands, with nothing done.
  [[nodiscard]] LinkOutcome outcome(LinkEnd end) const;

 private:
  [[nodiscard]] std::vector<firmware_link::Command> safe_sequence() const;
  // Whether it lifts the nozzle.
  [[nodiscard]] bool on_part() const;
  [[nodiscard]] LinkOutcome halt();
  [[nodiscard]] std::string send_and_hear();
  void close_journal(PrintState state);

  Parts parts_;
};

}  // namespace host
