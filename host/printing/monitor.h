// Runs the link: takes commands from the queue, feeds the session, watches for whatever must
// interrupt or end the print, and brings it to a safe end then.
//
//     queue ──try_pop──> history ──> session ──step──> port
//               ▲          │          │
//               │          │          ├─ lost, reset ──> waits, goes on behind what was executed
//               │          │          └─ other fault ──> safe sequence, as far as it is heard
//               │          └─ pause_control: off the part and back
//               └─ signal, geometry gave up ──> safe sequence ──> acknowledged, or M112
//
// Safe sequence: filament drawn back, nozzle lifted off the part, heaters off, fan off. What of it
// is possible depends on what was done so far: nothing is lifted before a height is known.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"                    // Status
#include "core/units.h"                     // LayerIndex, Length
#include "firmware_link/ports/byte_port.h"  // BytePort
#include "firmware_link/session/session.h"  // Session
#include "firmware_link/wire/command.h"     // Command
#include "host/pipeline/print_settings.h"   // PrintSettings
#include "host/pipeline/statistics.h"       // LinkStatistics
#include "host/printing/command_history.h"  // CommandHistory
#include "host/printing/controls.h"         // UserRequest
#include "host/printing/feed_throttle.h"    // FeedThrottle
#include "host/printing/journal.h"          // Journal
#include "host/printing/machine_space.h"    // MachineSpace
#include "host/printing/park_moves.h"       // ParkMoves
#include "host/printing/pause_control.h"    // PauseControl
#include "host/printing/progress.h"         // Reporter
#include "host/printing/queued_command.h"   // CommandQueue
#include "host/printing/resume_point.h"     // ResumePoint

namespace host {

enum class LinkEnd {
  kDone,           // the controller has acknowledged all
  kUserStopped,    // by the first signal, a key, or at the printer
  kUserHalted,     // by the second: M112
  kGeometryEnded,  // the filling side closed the queue
  kRefused,        // by options.may_begin
  kFaulted,        // link lost, or the controller gave up
};

struct LinkOutcome {
  LinkEnd end = LinkEnd::kDone;
  std::string reason;          // of a fault
  core::LayerIndex layer = 0;  // where it ended; 0: no road was sent
  core::Length height;
  std::string measures;  // "nozzle lifted, heaters off"; empty when there was nothing to do
};

// A print that is gone on with (`rind resume`).
struct Resumption {
  JournalRecord record;
  bool same_boot = true;
  std::int64_t nozzle_z_um = 0;  // where the nozzle is, as the operator says
};

// What is done when the port vanishes, or the controller resets, in mid-print.
struct LostPortOptions {
  double wait_s = 0;  // for the port to come back; 0: the print ends
  // Opens it again, under whichever name; null: not there yet.
  std::function<std::unique_ptr<firmware_link::BytePort>()> reopen;
  // Asks how high the nozzle is, when the controller has forgotten it; it should be at `z_um`.
  // Nothing: nobody answers, and the print ends.
  std::function<std::optional<std::int64_t>(std::int64_t z_um)> nozzle_height;
  // It takes what it should be for what it is (--yes): not asked when that is in doubt.
  bool takes_height = false;
};

struct MonitorOptions {
  double began_s = 0;               // steady_seconds() when the program began
  std::function<int()> stop_count;  // stop_urgency(): 0 go on, 1 a safe end, 2 halt
  std::function<std::int64_t()> slices_cut;
  std::function<core::LayerIndex()> layers;            // of the part; 0: not known yet
  std::function<std::vector<std::string>()> warnings;  // since it was asked last

  std::function<std::optional<UserRequest>()> request;  // may be empty
  std::function<double()> seconds_made;  // of motion, by geometry so far; may be empty
  double underrun_s = 0;                 // with nothing to lay: off the part; 0: never
  double hot_s = 600;                    // how long a paused nozzle stays hot
  double banner_wait_s = 2.5;            // for a `start` (SessionOptions)
  core::Box part;                        // where not to park
  core::Length height;                   // of the part; 0: not known
  std::optional<MachineSpace> space;     // nothing: as the settings say
  std::function<Journal*()> journal;     // null as long as there is none; may be empty
  // Called once, when it has said what it can do, before it is given a command; may be empty.
  std::function<void(const firmware_link::Capabilities&)> controller_known;
  // Likewise; an error ends the print, and nothing was given. May be empty.
  std::function<core::Status()> may_begin;
  LostPortOptions lost_port;
  std::optional<Resumption> resumption;
};

class Monitor {
 public:
  // REQUIRES: all outlive the monitor; functions set but for those that may be empty.
  Monitor(const PrintSettings& settings, MonitorOptions options, firmware_link::BytePort& port,
          CommandQueue& queue, Reporter& reporter);

  // To the end, whichever it is. Waits for the port a few milliseconds at a time.
  [[nodiscard]] LinkOutcome run();

  // After run() threw: halts the controller (M112), past the session.
  [[nodiscard]] LinkOutcome emergency(const std::string& reason);

  [[nodiscard]] const LinkStatistics& statistics() const { return statistics_; }

 private:
  // monitor.cpp: commands to the session.
  void begin_session(bool ask_found_line);
  [[nodiscard]] bool stop_asked() const { return options_.stop_count() > 0 || stop_requested_; }
  void feed(firmware_link::Instant now);
  [[nodiscard]] bool travel_asked(firmware_link::Instant now);
  [[nodiscard]] core::Status check_space();
  [[nodiscard]] bool begun(firmware_link::Instant now);
  [[nodiscard]] bool feed_one(firmware_link::Instant now);
  [[nodiscard]] const QueuedCommand* peek();
  void advance();
  void take(const QueuedCommand& queued, firmware_link::Instant now);
  void watch_queue(firmware_link::Instant now);
  void set_feed(firmware_link::Instant now);

  // monitor_reports.cpp: what people want, and are told.
  void take_requests(firmware_link::Instant now);
  void obey(UserRequest request, firmware_link::Instant now);
  void pause(bool wanted);
  void tell_phase(firmware_link::Instant now);
  void note_acknowledged();
  void tell_counts(const firmware_link::SessionStatistics& link);
  void tell_heat(const firmware_link::Temperatures& heat);
  void tell_events();
  void tell_event(const firmware_link::SessionEvent& event);
  void tell_action(const std::string& action);
  void report_progress();

  // monitor_recovery.cpp: journal, and going on.
  [[nodiscard]] Journal* journal() const { return options_.journal ? options_.journal() : nullptr; }
  [[nodiscard]] std::optional<std::int64_t> sure_before(std::int64_t accepted) const;
  [[nodiscard]] std::optional<JournalRecord> record(PrintState state) const;
  void keep_journal();
  void forget_lines(JournalRecord left, std::int64_t accepted, std::int64_t nozzle_z_um);
  void close_journal(PrintState state);
  [[nodiscard]] bool start_resumed();
  [[nodiscard]] firmware_link::FaultKind fault_kind() const { return session_->fault_kind(); }
  [[nodiscard]] bool recoverable() const;
  [[nodiscard]] std::optional<LinkOutcome> recover();
  [[nodiscard]] std::optional<LinkOutcome> reconnect(bool reset, double until_s);
  [[nodiscard]] std::vector<firmware_link::Command> way_back(const ResumePoint& point,
                                                             std::int64_t nozzle_z_um,
                                                             bool at_once) const;

  // monitor_place.cpp: where a controller that numbers nothing was found.
  [[nodiscard]] bool history_reaches(std::int64_t command);
  [[nodiscard]] ResumePoint point_of(const JournalRecord& left, bool same_boot) const;
  [[nodiscard]] std::string height_unknown(const ResumePoint& point) const;
  [[nodiscard]] LinkOutcome unplaced() const;

  // monitor_ends.cpp: how it ends.
  [[nodiscard]] std::vector<firmware_link::Command> safe_sequence() const;
  [[nodiscard]] LinkOutcome done();
  [[nodiscard]] LinkOutcome stop(LinkEnd end);
  [[nodiscard]] LinkOutcome halt();
  [[nodiscard]] LinkOutcome faulted();
  [[nodiscard]] LinkOutcome outcome(LinkEnd end) const;
  [[nodiscard]] std::string heaters_off_unheard();
  [[nodiscard]] std::string sent_and_heard();
  void hear();
  void flush_output(double limit_s);
  [[nodiscard]] bool moves_end();

  const PrintSettings& settings_;
  MonitorOptions options_;
  firmware_link::BytePort* port_;
  std::unique_ptr<firmware_link::BytePort> reopened_;
  CommandQueue& queue_;
  Reporter& reporter_;
  std::unique_ptr<firmware_link::Session> session_;
  LinkStatistics statistics_;
  LinkStatistics past_;  // of sessions that were lost

  // Commands by their number in the print: index_ is the next to take, session_base_ the first that
  // this session took.
  CommandHistory history_;
  std::int64_t index_ = 0;
  std::int64_t session_base_ = 0;
  std::int64_t sure_base_ = 0;            // executed, whatever became of the planner before it
  bool all_moved_ = false;                // what was accepted, whatever happens
  bool place_known_ = true;               // the session's controller was not reset before
  std::optional<QueuedCommand> waiting_;  // popped, not in the history
  QueuedCommand last_;                    // taken last
  int travel_asks_ = 0;                   // how often it was asked how far it may go
  bool begun_ = false;                    // the controller has been greeted, and may be used
  bool given_ = false;                    // anything at all, to any session
  bool unchecked_road_ = false;           // since the position was asked for
  std::int64_t first_road_ = 0;           // 1 + its number; 0: none yet
  bool finish_said_ = false;

  core::Settings machine_;  // settings_, with the space that there is
  ParkMoves park_moves_;
  PauseControl pauses_;
  FeedThrottle throttle_;
  int requested_feed_percent_ = 100;
  int requested_flow_percent_ = 100;
  int feed_percent_ = 100;  // as the controller was told
  bool stop_requested_ = false;
  std::string refused_;  // why; empty: it is not
  std::string pause_cause_ = "user";
  std::int64_t paused_before_ = -1;     // the command that has asked for it last
  std::optional<double> idle_since_s_;  // nothing to lay, and nothing in the planner

  bool history_started_ = false;  // of a resumption
  std::string unplaced_;          // why it cannot be told its height; empty: it can
  bool starting_ = false;         // a resumption whose point is not known yet
  std::int64_t skip_until_ = 0;   // executed before
  std::optional<ResumePoint> go_on_at_;

  std::string journaled_;  // the last record
  SyncPace sync_pace_;
  bool journal_complained_ = false;

  std::int64_t told_resends_ = 0;
  std::int64_t told_stalls_ = 0;
  core::LayerIndex told_layer_ = 0;
  firmware_link::Temperatures told_heat_;
};

}  // namespace host
