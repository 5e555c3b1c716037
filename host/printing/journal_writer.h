// Writes the journal of a running print: which records, and when.
//
//     on each turn, before bytes leave    keep()       a record when it differs from the last one
//     the print ends, or is interrupted   close()      the last record, and its state
//     a new session numbers from 1        renumber()   the lines before mean nothing any more
//     all was executed                    remove()
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "core/settings.h"                 // Settings
#include "core/units.h"                    // LayerIndex
#include "host/printing/journal.h"         // Journal, SyncPace
#include "host/printing/journal_record.h"  // JournalRecord
#include "host/printing/link_account.h"    // LinkAccount
#include "host/printing/pause_control.h"   // PauseControl
#include "host/printing/print_commands.h"  // PrintCommands
#include "host/printing/print_control.h"   // PrintControl
#include "host/printing/progress.h"        // Reporter

namespace host {

class JournalWriter {
 public:
  // All outlive the writer. `layers`: of the part; 0: not known yet.
  JournalWriter(const PrintCommands& commands, const PauseControl& pauses,
                const std::atomic<core::LayerIndex>& layers, PrintControl& control,
                Reporter& reporter)
      : commands_(commands),
        pauses_(pauses),
        layers_(layers),
        control_(control),
        reporter_(reporter) {}

  // Whose cancelled objects go into the journal; it outlives the writer.
  void watch(const PrintedObjects& objects) { objects_ = &objects; }

  // While a resumed print has not reached its resume point, the journal that it resumes from is the
  // true one: keep() and close() write nothing.
  void suspend(bool suspended) { suspended_ = suspended; }

  // A new session has resumed. All before command `sure` was executed, whatever became of the
  // planner. `position_known`: the controller was not reset.
  void start_session(std::int64_t sure, bool position_known);

  // All that was accepted has moved, whatever happens now.
  void note_all_moved() { all_moved_ = true; }

  // The print as it stands. Nothing: no road was given, or more is in doubt than the history holds.
  [[nodiscard]] std::optional<JournalRecord> record(PrintState state,
                                                    const LinkAccount& account) const;

  // Whether keep() would write.
  [[nodiscard]] bool keeps() const;
  // Before bytes leave: whatever the controller may get is in the journal.
  void keep(const LinkAccount& account);

  // The print has ended. A safe stop (PrintState::kStopped) has lifted the nozzle, as far as
  // `machine` says (lifted_um()).
  void close(PrintState state, const LinkAccount& account, const core::Settings& machine);
  // It is interrupted.
  void close(const JournalRecord& last);

  // The print resumes with command `accepted`, by a session that numbers lines from 1: no record
  // may hold on to the numbers in `left`.
  void renumber(JournalRecord left, std::int64_t accepted, std::int64_t nozzle_z_um);

  // The print is done.
  void remove();

 private:
  [[nodiscard]] std::optional<std::int64_t> sure_before(std::int64_t accepted,
                                                        const LinkAccount& account) const;

  const PrintCommands& commands_;
  const PauseControl& pauses_;
  const std::atomic<core::LayerIndex>& layers_;
  const PrintedObjects* objects_ = nullptr;
  PrintControl& control_;
  Reporter& reporter_;
  bool suspended_ = false;
  bool position_known_ = true;  // the session's controller was not reset before it
  bool all_moved_ = false;
  std::int64_t sure_base_ = 0;
  std::string written_;  // the last record's bytes
  SyncPace sync_pace_;
  bool complained_ = false;
};

}  // namespace host
