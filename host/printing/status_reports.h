// What people and programs are told of a running print, and what its statistics count.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/units.h"                           // LayerIndex
#include "firmware_link/session/session.h"        // Session
#include "firmware_link/session/session_event.h"  // SessionEvent
#include "host/pipeline/pipeline.h"               // PipelineSignals
#include "host/pipeline/statistics.h"             // LinkStatistics
#include "host/printing/controls.h"               // UserRequest
#include "host/printing/feed_override.h"          // FeedOverride
#include "host/printing/pause_control.h"          // PauseControl
#include "host/printing/print_commands.h"         // PrintCommands
#include "host/printing/progress.h"               // Reporter

namespace host {

class StatusReports {
 public:
  // `started_s`: steady_seconds() when the program started. All outlive the reports.
  StatusReports(double started_s, const PrintCommands& commands, PipelineSignals& signals,
                Reporter& reporter)
      : started_s_(started_s), commands_(commands), signals_(signals), reporter_(reporter) {}

  [[nodiscard]] LinkStatistics& statistics() { return statistics_; }
  [[nodiscard]] const LinkStatistics& statistics() const { return statistics_; }

  // The session is lost: the next one counts from 0.
  void start_session() { past_ = statistics_; }

  // Takes the session's counts into the statistics; tells what has changed.
  void note_counts(const firmware_link::SessionStatistics& link);

  // `greeted`: the controller was given commands already.
  void tell_event(const firmware_link::SessionEvent& event, const firmware_link::Session& session,
                  bool greeted);
  void tell_pause(PauseControl::Phase phase, const std::string& cause, double hot_s);
  // The feed or the flow was changed by this request.
  void tell_override(UserRequest request, const FeedOverride& feed);
  // So much filament is left on the spool; it is counted down by the roads laid. `resumed`: what
  // was laid before does not count.
  void count_down(std::optional<double> spool_left_mm, bool resumed) {
    spool_left_mm_ = spool_left_mm;
    if (!resumed) counted_from_mm_ = 0;
  }
  // Which objects can be cancelled, by number.
  void tell_objects();
  // `from`: the first layer without it; nothing: it can't be cancelled, and false is returned.
  bool tell_cancelled(int number, std::optional<core::LayerIndex> from);
  void tell_fault(const std::string& reason, bool reset, double wait_s);

  // When it is due. Warnings that geometry has left are told at once.
  void show_progress(const firmware_link::Session& session);

 private:
  void tell_spool();
  void tell_counts(const firmware_link::SessionStatistics& link);
  void tell_heat(const firmware_link::Temperatures& heat);
  void tell_action(const std::string& action);
  [[nodiscard]] std::string_view state(const firmware_link::Temperatures& heat) const;
  // Nothing: it is not known, or not yet.
  [[nodiscard]] std::optional<double> spool_now_mm() const;
  [[nodiscard]] std::optional<double> left_s(const ProgressReport& report) const;

  double started_s_;
  const PrintCommands& commands_;
  PipelineSignals& signals_;
  Reporter& reporter_;
  LinkStatistics statistics_;
  LinkStatistics past_;  // of sessions that were lost
  std::int64_t told_resends_ = 0;
  std::int64_t told_stalls_ = 0;
  core::LayerIndex told_layer_ = 0;
  core::LayerIndex first_layer_ = 0;  // that this program lays; others were laid before
  PauseControl::Phase phase_ = PauseControl::Phase::kPrinting;
  double pause_began_s_ = 0;
  double paused_s_ = 0;  // in pauses that have ended
  firmware_link::Temperatures told_heat_;
  std::optional<double> spool_left_mm_;
  std::optional<double> counted_from_mm_;  // filament in roads when it was so much
  bool told_spool_low_ = false;
};

}  // namespace host
