// What people want of a running print, and what they are told.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "host/printing/monitor.h"
#include "host/system/stage_clock.h"  // steady_seconds

namespace host {
namespace {

using firmware_link::Instant;
using firmware_link::SessionState;

constexpr int kStep_percent = 10;
constexpr int kPercentMin = 10;
constexpr int kPercentMax = 300;

}  // namespace

void Monitor::take_requests(Instant now) {
  while (options_.request) {
    const std::optional<UserRequest> request = options_.request();
    if (!request) return;
    obey(*request, now);
  }
}

void Monitor::obey(UserRequest request, Instant now) {
  const auto change = [](int& percent, int by) {
    percent = std::clamp(percent + by, kPercentMin, kPercentMax);
  };
  switch (request) {
    case UserRequest::kPause:
      pause(true);
      return;
    case UserRequest::kResume:
      session_->answer_user(now);
      pause(false);
      return;
    case UserRequest::kToggle:
      pause(!pauses_.pause_wanted());
      return;
    case UserRequest::kStop:
      stop_requested_ = true;
      return;
    case UserRequest::kHelp:
      reporter_.note("keys", key_help());
      return;
    case UserRequest::kFeedUp:
    case UserRequest::kFeedDown:
      change(requested_feed_percent_,
             request == UserRequest::kFeedUp ? kStep_percent : -kStep_percent);
      set_feed(now);
      reporter_.note("feed", fmt::format("feed {} %", requested_feed_percent_),
                     {{"percent", std::int64_t{requested_feed_percent_}}});
      return;
    case UserRequest::kFlowUp:
    case UserRequest::kFlowDown:
      change(requested_flow_percent_,
             request == UserRequest::kFlowUp ? kStep_percent : -kStep_percent);
      if (session_->state() == SessionState::kStreaming) {
        session_->set_flow_percent(requested_flow_percent_, now);
      }
      reporter_.note("flow", fmt::format("flow {} %", requested_flow_percent_),
                     {{"percent", std::int64_t{requested_flow_percent_}}});
      return;
  }
}

// A person wants it so.
void Monitor::pause(bool wanted) {
  if (!pauses_.pause_wanted()) pause_cause_ = "user";
  pauses_.want_pause(wanted);
}

void Monitor::tell_phase(Instant now) {
  const std::string cause = pauses_.pause_wanted() ? pause_cause_ : "geometry";
  switch (pauses_.phase()) {
    case PauseControl::Phase::kLeaving:
      session_->hold(true, now);
      reporter_.note("pause",
                     cause == "geometry" ? "geometry has fallen behind: the nozzle leaves the part"
                                         : "pausing: the nozzle leaves the part",
                     {{"cause", cause}, {"layer", last_.layer}});
      return;
    case PauseControl::Phase::kAway:
      reporter_.note("paused",
                     fmt::format("paused at layer {}; the nozzle stays hot for {:.0f} s, the bed "
                                 "stays warm",
                                 last_.layer, options_.hot_s),
                     {{"cause", cause}, {"layer", last_.layer}});
      return;
    case PauseControl::Phase::kReturning:
      reporter_.note("resume", "going on", {{"layer", last_.layer}});
      return;
    case PauseControl::Phase::kPrinting:
      session_->hold(false, now);
      reporter_.note("resumed", "printing again", {{"layer", last_.layer}});
      return;
  }
}

void Monitor::note_acknowledged() {
  const firmware_link::SessionStatistics link = session_->statistics();
  statistics_.commands = past_.commands + link.commands_acknowledged;
  statistics_.stalls = past_.stalls + link.stalls;
  statistics_.resends = past_.resends + link.resends;
  statistics_.resend_ratio = link.resend_ratio();
  statistics_.planner_low_s = past_.planner_low_s + link.planner_low_s;
  const std::int64_t accepted = session_base_ + link.commands_acknowledged;
  if (!statistics_.first_command_s && link.commands_acknowledged > 0) {
    statistics_.first_command_s = steady_seconds() - options_.began_s;
  }
  if (!statistics_.first_road_s && first_road_ > 0 && accepted >= first_road_) {
    statistics_.first_road_s = steady_seconds() - options_.began_s;
    statistics_.first_road_cpu_s = process_cpu_seconds();
    statistics_.slices_cut_at_first_road = options_.slices_cut();
  }
  tell_counts(link);
}

// For those who read events; people see them in the end.
void Monitor::tell_counts(const firmware_link::SessionStatistics& link) {
  if (statistics_.resends > told_resends_) {
    reporter_.event("resend", {{"resends", statistics_.resends}});
  }
  if (statistics_.stalls > told_stalls_) {
    reporter_.event("stall",
                    {{"stalls", statistics_.stalls}, {"planner_low_s", link.planner_low_s}});
  }
  if (last_.layer != told_layer_) {
    reporter_.event(
        "layer",
        {{"layer", last_.layer}, {"layers", options_.layers()}, {"height_mm", last_.top.mm()}});
  }
  tell_heat(link.temperatures);
  told_resends_ = statistics_.resends;
  told_stalls_ = statistics_.stalls;
  told_layer_ = last_.layer;
}

void Monitor::tell_heat(const firmware_link::Temperatures& heat) {
  const auto moved = [](const std::optional<double>& now, const std::optional<double>& told) {
    return now && (!told || std::abs(*now - *told) >= 1);
  };
  if (!moved(heat.nozzle_celsius, told_heat_.nozzle_celsius) &&
      !moved(heat.nozzle_target_celsius, told_heat_.nozzle_target_celsius) &&
      !moved(heat.bed_celsius, told_heat_.bed_celsius) &&
      !moved(heat.bed_target_celsius, told_heat_.bed_target_celsius)) {
    return;
  }
  told_heat_ = heat;
  EventFields fields;
  const auto add = [&fields](const char* key, std::optional<double> value) {
    if (value) fields.emplace_back(key, *value);
  };
  add("nozzle_celsius", heat.nozzle_celsius);
  add("nozzle_target_celsius", heat.nozzle_target_celsius);
  add("bed_celsius", heat.bed_celsius);
  add("bed_target_celsius", heat.bed_target_celsius);
  reporter_.event("temperature", std::move(fields));
}

void Monitor::tell_events() {
  while (const auto event = session_->next_event()) tell_event(*event);
}

void Monitor::tell_event(const firmware_link::SessionEvent& event) {
  using Kind = firmware_link::SessionEvent::Kind;
  switch (event.kind) {
    case Kind::kDialect:
      reporter_.note("controller", session_->firmware_name() + ", speaks as " + event.text);
      return;
    case Kind::kPauseAsked:
      reporter_.note("action", "pause was asked for at the printer");
      pause(true);
      return;
    case Kind::kResumeAsked:
      reporter_.note("action", "going on was asked for at the printer");
      pause(false);
      return;
    case Kind::kCancelAsked:
      reporter_.note("action", "the print was cancelled at the printer");
      stop_requested_ = true;
      return;
    case Kind::kWarning:
      // It does not tell how far its axes go, and need not.
      if (const std::string_view question = session_->rules().travel_question;
          !begun_ && !question.empty() && event.text.find(question) != std::string::npos) {
        return;
      }
      reporter_.note("warning", "the controller says: " + event.text);
      return;
    case Kind::kWaits:
      reporter_.note("waiting", "waiting for " + event.text);
      return;
    case Kind::kWaitsForUser:
      reporter_.note("waiting",
                     "the printer waits for its user: press its button, or let it go on from here");
      return;
    case Kind::kResendsFrequent:
      reporter_.note("resends", event.text);
      return;
    case Kind::kNotReady:
      reporter_.note("waiting", "the printer is not ready yet: it says \"" + event.text +
                                    "\"; waiting for it, for two minutes at most");
      return;
    case Kind::kStopWaits:
      reporter_.note("waiting",
                     "the stop waits for the printer to end " +
                         (event.text.empty() ? "what it is at" : event.text) +
                         "; Ctrl-C once more halts it at once, and it needs a reset then");
      return;
    case Kind::kFilamentCorrected:
      reporter_.note("corrected", "a line ran in part: " + event.text + ", made up for");
      return;
    default:
      tell_action(event.text);
      return;
  }
}

// Actions are words for programs. Those who read events get all of them, people what is for them.
void Monitor::tell_action(const std::string& action) {
  const auto behind = [&](std::string_view word) -> std::optional<std::string> {
    if (action.compare(0, word.size(), word) != 0) return std::nullopt;
    const std::size_t text = action.find_first_not_of(' ', word.size());
    return text == std::string::npos ? std::string() : action.substr(text);
  };
  if (const auto question = behind("prompt_begin"); question && !question->empty()) {
    reporter_.note("action", "the printer asks, on its display: " + *question);
  } else if (behind("out_of_filament")) {
    reporter_.note("action", "the printer has run out of filament");
  } else if (action == "paused" || action == "resumed") {
    reporter_.note("action", action == "paused" ? "the printer has paused by itself"
                                                : "the printer goes on by itself");
  } else {
    reporter_.event("action", {{"text", action}});
  }
}

void Monitor::report_progress() {
  const double now = steady_seconds();
  for (const std::string& warning : options_.warnings()) reporter_.note("warning", warning);
  if (!reporter_.progress_due(now)) return;
  ProgressReport report;
  report.layer = last_.layer;
  report.layers = options_.layers();
  report.height = last_.top;
  report.filament_mm = last_.filament_mm;
  report.elapsed_s = now - options_.began_s;
  if (statistics_.first_road_s && last_.layer > 1 && report.layers > 0) {
    const double printing_s = report.elapsed_s - *statistics_.first_road_s;
    report.left_s = printing_s * static_cast<double>(report.layers - last_.layer + 1) /
                    static_cast<double>(last_.layer - 1);
  }
  const firmware_link::SessionStatistics link = session_->statistics();
  report.nozzle_celsius = link.temperatures.nozzle_celsius;
  report.nozzle_target_celsius = link.temperatures.nozzle_target_celsius;
  report.bed_celsius = link.temperatures.bed_celsius;
  report.bed_target_celsius = link.temperatures.bed_target_celsius;
  report.lines_in_flight = link.lines_in_flight;
  report.queue_share =
      static_cast<double>(queue_.level().items) / static_cast<double>(queue_.limits().items);
  reporter_.progress(report, now);
}

}  // namespace host
