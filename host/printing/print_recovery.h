// Where a print resumes, and how the nozzle gets back there.
//
//     rind resume            find_start() ──> what was executed is skipped ──> start_way_back()
//     lost port, reset       resume_after_fault()
//
// resume_point.h has the rules by which a command is chosen.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firmware_link/wire/command.h"    // Command
#include "firmware_link/wire/instant.h"    // Instant
#include "host/printing/journal_record.h"  // JournalRecord
#include "host/printing/journal_writer.h"  // JournalWriter
#include "host/printing/pause_control.h"   // PauseControl
#include "host/printing/print_commands.h"  // PrintCommands
#include "host/printing/print_control.h"   // PrintControl
#include "host/printing/print_start.h"     // PrintStart
#include "host/printing/printer_link.h"    // PrinterLink
#include "host/printing/progress.h"        // Reporter
#include "host/printing/resume_point.h"    // ResumePoint

namespace host {

// A print that is resumed (`rind resume`).
struct Resumption {
  JournalRecord record;
  bool same_boot = true;         // the computer was not restarted since
  std::int64_t nozzle_z_um = 0;  // where the nozzle is, as the operator says
};

class PrintRecovery {
 public:
  // What of a running print a recovery reads and sets. All outlive it.
  struct Parts {
    PrinterLink& link;
    PrintCommands& commands;
    PauseControl& pauses;
    const PrintStart& start;
    JournalWriter& journal;
    PrintControl& control;
    Reporter& reporter;
  };
  PrintRecovery(const Parts& parts, std::optional<Resumption> resumption);

  // --- rind resume ---

  // Whether the resume point is still looked for.
  [[nodiscard]] bool searching() const { return searching_; }
  // Whether the nozzle has not set out for the resume point yet.
  [[nodiscard]] bool pending() const { return searching_ || start_point_.has_value(); }

  // Finds the resume point. False: geometry has not computed as far as that, or failure() says why
  // there is none. REQUIRES: searching(), and the session is streaming.
  [[nodiscard]] bool find_start();
  [[nodiscard]] const std::string& failure() const { return failure_; }

  // Once all that was executed is skipped: the nozzle sets out. False: it had already.
  [[nodiscard]] bool start_way_back(firmware_link::Instant now);

  // --- a lost port, a reset ---

  // Whether enough is known of the print to resume it: a road was given, and the machine's position
  // behind all that was given is known.
  [[nodiscard]] bool possible() const;

  struct Failure {
    std::string reason;  // beyond that of the fault; may be empty
    std::string measures;
  };
  // The session is a new one, and streaming. Has the print resumed from where `left` says; nothing:
  // it is. `fault_s`: steady_seconds() at the fault.
  [[nodiscard]] std::optional<Failure> resume_after_fault(const JournalRecord& left,
                                                          double fault_s);

 private:
  [[nodiscard]] ResumePoint point_of(const JournalRecord& left, bool same_boot) const;
  [[nodiscard]] const FilePlace* file_before(std::int64_t command) const;
  [[nodiscard]] std::string height_unknown(const ResumePoint& point) const;
  [[nodiscard]] std::vector<firmware_link::Command> way_back(const ResumePoint& point,
                                                             std::int64_t nozzle_z_um,
                                                             bool still_hot) const;
  void end_search();
  void set_out(const ResumePoint& point, std::int64_t nozzle_z_um, bool still_hot,
               firmware_link::Instant now);

  Parts parts_;
  std::optional<Resumption> resumption_;
  bool searching_;
  bool history_started_ = false;
  std::string failure_;
  std::optional<ResumePoint> start_point_;
};

}  // namespace host
