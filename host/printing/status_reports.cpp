#include "host/printing/status_reports.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "host/system/limits.h"       // kSpoolLow_mm
#include "host/system/stage_clock.h"  // steady_seconds

namespace host {

void StatusReports::note_counts(const firmware_link::SessionStatistics& link) {
  statistics_.commands = past_.commands + link.commands_acknowledged;
  statistics_.stalls = past_.stalls + link.stalls;
  statistics_.resends = past_.resends + link.resends;
  statistics_.resend_ratio = link.resend_ratio();
  statistics_.planner_low_s = past_.planner_low_s + link.planner_low_s;
  const std::int64_t accepted = commands_.session_first() + link.commands_acknowledged;
  if (!statistics_.first_command_s && link.commands_acknowledged > 0) {
    statistics_.first_command_s = steady_seconds() - started_s_;
  }
  if (!statistics_.first_road_s && commands_.road_given() && accepted >= commands_.first_road()) {
    statistics_.first_road_s = steady_seconds() - started_s_;
    statistics_.first_road_cpu_s = process_cpu_seconds();
    statistics_.slices_cut_at_first_road = signals_.slices_cut.load();
    first_layer_ = commands_.last().layer;
  }
  tell_counts(link);
}

// For those who read events; people see them in the end.
void StatusReports::tell_counts(const firmware_link::SessionStatistics& link) {
  const QueuedCommand& last = commands_.last();
  if (statistics_.resends > told_resends_) {
    reporter_.event("resend", {{"resends", statistics_.resends}});
  }
  // Before the first road there is nothing that a gap could spoil.
  if (statistics_.stalls > told_stalls_ && statistics_.first_road_s) {
    reporter_.event("stall",
                    {{"stalls", statistics_.stalls}, {"planner_low_s", link.planner_low_s}});
  }
  if (last.layer != told_layer_) {
    reporter_.event(
        "layer",
        {{"layer", last.layer}, {"layers", signals_.layers.load()}, {"height_mm", last.top.mm()}});
  }
  tell_heat(link.temperatures);
  told_resends_ = statistics_.resends;
  told_stalls_ = statistics_.stalls;
  told_layer_ = last.layer;
}

void StatusReports::tell_heat(const firmware_link::Temperatures& heat) {
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
  reporter_.event("temperature", fields);
}

void StatusReports::tell_event(const firmware_link::SessionEvent& event,
                               const firmware_link::Session& session, bool greeted) {
  using Kind = firmware_link::SessionEvent::Kind;
  switch (event.kind) {
    case Kind::kDialect:
      reporter_.note("controller", session.firmware_name() + ", speaks as " + event.text);
      return;
    case Kind::kPauseAsked:
      reporter_.note("action", "pause was asked for at the printer");
      return;
    case Kind::kResumeAsked:
      reporter_.note("action", "resume was asked for at the printer");
      return;
    case Kind::kCancelAsked:
      reporter_.note("action", "the print was cancelled at the printer");
      return;
    case Kind::kWarning: {
      // It does not tell how far its axes go, and need not.
      const std::string_view question = session.rules().travel_question;
      const bool answers_us = !question.empty() && event.text.find(question) != std::string::npos;
      if (!greeted && answers_us) return;
      reporter_.note("warning", "the controller says: " + event.text);
      return;
    }
    case Kind::kWaits:
      reporter_.note("waiting", "waiting for " + event.text);
      return;
    case Kind::kWaitsForUser:
      reporter_.note("waiting",
                     "the printer waits for its user: press its button, or resume it from here");
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
                         (event.text.empty() ? "what it is doing" : event.text) +
                         "; Ctrl-C once more halts it at once, and it needs a reset then");
      return;
    case Kind::kFilamentCorrected:
      reporter_.note("corrected", "a line was executed in part: " + event.text + ", made up for");
      return;
    default:
      tell_action(event.text);
      return;
  }
}

// Actions are words for programs. Those who read events get all of them, people what is for them.
void StatusReports::tell_action(const std::string& action) {
  const auto text_after = [&](std::string_view word) -> std::optional<std::string> {
    if (action.compare(0, word.size(), word) != 0) return std::nullopt;
    const std::size_t text = action.find_first_not_of(' ', word.size());
    return text == std::string::npos ? std::string() : action.substr(text);
  };
  if (const auto question = text_after("prompt_begin"); question && !question->empty()) {
    reporter_.note("action", "the printer asks, on its display: " + *question);
  } else if (text_after("out_of_filament")) {
    reporter_.note("action", "the printer has run out of filament");
  } else if (action == "paused" || action == "resumed") {
    reporter_.note("action", action == "paused" ? "the printer has paused by itself"
                                                : "the printer has resumed by itself");
  } else {
    reporter_.event("action", {{"text", action}});
  }
}

void StatusReports::tell_pause(PauseControl::Phase phase, const std::string& cause, double hot_s) {
  const core::LayerIndex layer = commands_.last().layer;
  const double now = steady_seconds();
  if (phase_ == PauseControl::Phase::kPrinting) pause_began_s_ = now;
  if (phase == PauseControl::Phase::kPrinting) paused_s_ += now - pause_began_s_;
  phase_ = phase;
  switch (phase) {
    case PauseControl::Phase::kLeaving:
      reporter_.note("pause",
                     cause == "geometry" ? "geometry has fallen behind: the nozzle leaves the part"
                                         : "pausing: the nozzle leaves the part",
                     {{"cause", cause}, {"layer", layer}});
      return;
    case PauseControl::Phase::kAway:
      reporter_.note("paused",
                     fmt::format("paused at layer {}; the nozzle stays hot for {:.0f} s, the bed "
                                 "stays warm",
                                 layer, hot_s),
                     {{"cause", cause}, {"layer", layer}});
      return;
    case PauseControl::Phase::kReturning:
      reporter_.note("resume", "resuming: the nozzle returns to the part", {{"layer", layer}});
      return;
    case PauseControl::Phase::kPrinting:
      reporter_.note("resumed", "printing again", {{"layer", layer}});
      return;
  }
}

void StatusReports::tell_override(UserRequest request, const FeedOverride& feed) {
  const bool is_flow = request == UserRequest::kFlowUp || request == UserRequest::kFlowDown;
  const std::int64_t percent = is_flow ? feed.requested_flow() : feed.requested_feed();
  const std::string name = is_flow ? "flow" : "feed";
  reporter_.note(name, fmt::format("{} {} %", name, percent), {{"percent", percent}});
}

void StatusReports::tell_objects() {
  const std::vector<std::string> names = signals_.objects.names();
  if (names.empty()) return reporter_.note("objects", "there is one object: s stops the print");
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (signals_.objects.is_cancelled(static_cast<int>(i))) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", i + 1, names[i]);
  }
  reporter_.note("objects",
                 text + "; to cancel one, type its number and Enter; any other key leaves all");
}

bool StatusReports::tell_cancelled(int number, std::optional<core::LayerIndex> from) {
  const std::vector<std::string> names = signals_.objects.names();
  if (!from) {
    reporter_.note("objects", fmt::format("object {} can't be cancelled: there are {}, and it may "
                                          "be cancelled already",
                                          number, names.size()));
    return false;
  }
  const std::string& name = names[static_cast<std::size_t>(number) - 1];
  reporter_.note("cancelled",
                 fmt::format("object {}, {}, is cancelled: it is left out from layer {} on, and "
                             "what is queued of it is skipped",
                             number, name, *from + 1),
                 {{"object", number}, {"name", name}, {"layer", *from + 1}});
  return true;
}

void StatusReports::tell_fault(const std::string& reason, bool reset, double wait_s) {
  reporter_.note(
      "fault",
      reset ? reason : fmt::format("{}; waiting {:.0f} s for it to come back", reason, wait_s),
      {{"kind", std::string(reset ? "reset" : "port_lost")}, {"layer", commands_.last().layer}});
}

std::string_view StatusReports::state(const firmware_link::Temperatures& heat) const {
  switch (phase_) {
    case PauseControl::Phase::kPrinting:
      break;
    case PauseControl::Phase::kReturning:
      return "resuming";
    default:
      return "paused";
  }
  if (statistics_.first_road_s) return {};
  constexpr double kNear_celsius = 3;
  const auto is_cold = [](std::optional<double> is, std::optional<double> wanted) {
    return is && wanted && *wanted > 0 && *is < *wanted - kNear_celsius;
  };
  const bool heats = is_cold(heat.nozzle_celsius, heat.nozzle_target_celsius) ||
                     is_cold(heat.bed_celsius, heat.bed_target_celsius);
  return heats ? "heating" : "starting";
}

// At the pace of the layers so far, pauses left out.
std::optional<double> StatusReports::left_s(const ProgressReport& report) const {
  if (!statistics_.first_road_s || report.layers <= 0 || report.layer <= first_layer_) {
    return std::nullopt;
  }
  const bool prints = phase_ == PauseControl::Phase::kPrinting;
  const double until_s = prints ? report.elapsed_s : pause_began_s_ - started_s_;
  const double printing_s = until_s - *statistics_.first_road_s - paused_s_;
  return printing_s * static_cast<double>(report.layers - report.layer + 1) /
         static_cast<double>(report.layer - first_layer_);
}

std::optional<double> StatusReports::spool_now_mm() const {
  if (!spool_left_mm_ || !counted_from_mm_) return std::nullopt;
  return *spool_left_mm_ - (commands_.last().filament_mm - *counted_from_mm_);
}

// Once, while there is time to change it in a pause.
void StatusReports::tell_spool() {
  if (!spool_left_mm_ || commands_.last().filament_mm == 0) return;
  if (!counted_from_mm_) counted_from_mm_ = commands_.last().filament_mm;
  const double left_mm = *spool_now_mm();
  if (told_spool_low_ || left_mm > kSpoolLow_mm) return;
  told_spool_low_ = true;
  reporter_.note("spool_low",
                 fmt::format("about {:.2f} m of filament are left on the spool: pause to change it "
                             "before it ends",
                             std::max(left_mm, 0.0) / 1'000),
                 {{"spool_left_mm", left_mm}});
}

void StatusReports::show_progress(const firmware_link::Session& session) {
  const double now = steady_seconds();
  for (const std::string& warning : signals_.warnings.take()) reporter_.note("warning", warning);
  tell_spool();
  if (!reporter_.progress_due(now)) return;
  const QueuedCommand& last = commands_.last();
  ProgressReport report;
  report.layer = last.layer;
  report.layers = signals_.layers.load();
  report.height = last.top;
  report.preparation = signals_.preparation.get();
  report.filament_mm = last.filament_mm;
  report.spool_left_mm = spool_now_mm();
  report.elapsed_s = now - started_s_;
  report.left_s = left_s(report);
  if (const double all_s = signals_.full_speed_s.load(); all_s > 0) {
    report.share = std::clamp(last.seconds / all_s, 0.0, 1.0);
    report.left_s = (1 - *report.share) * signals_.time_s.load();
  }
  const firmware_link::SessionStatistics link = session.statistics();
  report.state = state(link.temperatures);
  report.nozzle_celsius = link.temperatures.nozzle_celsius;
  report.nozzle_target_celsius = link.temperatures.nozzle_target_celsius;
  report.bed_celsius = link.temperatures.bed_celsius;
  report.bed_target_celsius = link.temperatures.bed_target_celsius;
  report.lines_in_flight = link.lines_in_flight;
  const CommandQueue& queue = commands_.queue();
  report.queue_share =
      static_cast<double>(queue.level().items) / static_cast<double>(queue.limits().items);
  reporter_.progress(report, now);
}

}  // namespace host
