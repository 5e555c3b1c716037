#include "host/commands/spool_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "host/commands/commands.h"
#include "host/commands/ready_plan.h"  // open_ready
#include "host/printing/controls.h"
#include "host/system/exit_codes.h"
#include "host/system/stop_signals.h"
#include "host/system/text.h"  // trimmed

namespace host {
namespace {

std::string length_text(double mm) {
  return mm < 1'000 ? fmt::format("{:.1f} mm", mm) : fmt::format("{:.2f} m", mm / 1'000);
}

core::Result<SpoolCheck> of_ready(const Options& options, const std::shared_ptr<ReadyFile>& file,
                                  double used_mm, Reporter& quiet) {
  const core::Result<WholeSettings> whole = load_settings_of(options, quiet);
  if (!whole.ok()) return whole.error();
  const PrintSettings& settings = whole.value().settings;
  const core::Result<double> left_mm = spool_mm(*options.spool_left, settings);
  if (!left_mm.ok()) return left_mm.error();
  const core::Result<PrintPlan> plan = ready_plan(options, settings, file, quiet);
  if (!plan.ok()) return plan.error();
  const ReadySummary& summary = file->summary();
  return spool_check(left_mm.value(), summary.needed_mm, summary.needed_to_change_mm, used_mm);
}

core::Result<SpoolCheck> planned(const Options& told, double used_mm, Reporter& reporter) {
  Options options = told;
  // The height was confirmed when the print was started.
  if (told.subcommand == Subcommand::kResume) options.part.tall = true;
  options.subcommand = Subcommand::kPlan;  // reads all
  // The print itself tells its notes.
  Reporter::Options silent;
  silent.quiet = true;
  Reporter quiet(silent);
  const core::Result<std::shared_ptr<ReadyFile>> ready = open_ready(options);
  if (!ready.ok()) return ready.error();
  if (ready.value()) return of_ready(options, ready.value(), used_mm, quiet);
  core::Result<PrintPlan> opened = open_print_plan(options, quiet);
  if (!opened.ok()) return opened.error();
  PrintPlan& plan = opened.value();
  const core::Result<double> left_mm = spool_mm(*options.spool_left, plan.settings);
  if (!left_mm.ok()) return left_mm.error();
  reporter.note("spool", "planning the whole print first, for --spool-left");
  PipelineOutputs outputs;
  outputs.on_motion = [](const auto&, const auto&) { return stop_signal_count() == 0; };
  outputs.on_roads_text = [](std::string_view) { return stop_signal_count() == 0; };
  PipelineSignals signals;
  connect_signals(signals, reporter);
  GeometryStatistics statistics;
  const core::Result<PipelineEnd> end = run_pipeline(plan, outputs, signals, statistics);
  if (!end.ok()) return end.error();
  return spool_check(left_mm.value(), statistics.needed.mm, statistics.needed.to_change_mm,
                     used_mm);
}

// Whether the print may begin all the same.
bool consents(const std::string& what) {
  Controls controls(false);
  const std::optional<std::string> answer = controls.ask(
      what + "\np to print all the same, s to stop:", [] { return stop_signal_count() > 0; });
  return answer && trimmed(*answer) == "p";
}

}  // namespace

SpoolCheck spool_check(double left_mm, double needed_mm, std::optional<double> to_change_mm,
                       double used_mm) {
  // A print that is resumed may have a new spool already.
  const bool until_change = to_change_mm && *to_change_mm > used_mm;
  const double until_mm = until_change ? *to_change_mm : needed_mm;
  return {left_mm, std::max(0.0, until_mm - used_mm), until_change};
}

std::string spool_text(const SpoolCheck& check) {
  const double rest_mm = check.left_mm - check.needed_mm;
  return fmt::format("{} are left: {}{}", length_text(check.left_mm),
                     check.enough()
                         ? fmt::format("enough, {} stay on the spool", length_text(rest_mm))
                         : fmt::format("too short by {}", length_text(-rest_mm)),
                     check.until_change ? ", when M600 asks for another one" : "");
}

core::Result<std::optional<double>> spool_left_mm(const Options& options,
                                                  const core::Settings& settings) {
  if (!options.spool_left) return std::optional<double>();
  const core::Result<double> left_mm = spool_mm(*options.spool_left, settings);
  if (!left_mm.ok()) return left_mm.error();
  return std::optional(left_mm.value());
}

std::optional<int> check_spool(const Options& options, Reporter& reporter, double used_mm) {
  if (!options.spool_left) return std::nullopt;
  if (!rereadable(options)) {
    reporter.note("warning",
                  "a part from a pipe can't be planned first: whether the spool is enough is not "
                  "known; what is left is counted down while it is printed");
    return std::nullopt;
  }
  const core::Result<SpoolCheck> check = planned(options, used_mm, reporter);
  if (stop_signal_count() > 0) return stopped(options, reporter);
  if (!check.ok()) return fail(check.error(), reporter);
  const std::string text = fmt::format(
      "{} needs {:.2f} m of filament{}; {}", used_mm > 0 ? "the rest of the print" : "the print",
      check.value().needed_mm / 1'000,
      check.value().until_change ? " until it is changed by M600" : "", spool_text(check.value()));
  const EventFields fields = {{"needed_mm", check.value().needed_mm},
                              {"spool_left_mm", check.value().left_mm},
                              {"spool_enough", check.value().enough()}};
  if (check.value().enough()) {
    reporter.note("spool", text, fields);
    return std::nullopt;
  }
  reporter.clear();
  if (consents(text)) return std::nullopt;
  if (stop_signal_count() > 0) return stopped(options, reporter);
  reporter.error(text +
                     "; to print all the same and change the filament in a pause, leave out "
                     "--spool-left",
                 kExitUsage);
  return kExitUsage;
}

std::optional<double> counted_down_mm(std::optional<double> left_mm, const PrintPlan& print_plan) {
  const std::vector<std::string>& actions = print_plan.settings.at_height;
  const bool changes = print_plan.ready
                           ? print_plan.ready->summary().needed_to_change_mm.has_value()
                           : std::any_of(actions.begin(), actions.end(), [](const auto& action) {
                               return action.find("M600") != std::string::npos;
                             });
  return changes ? std::nullopt : left_mm;
}

bool rereadable(const Options& options) {
  const std::vector<std::string> paths = part_paths(options);
  return std::all_of(paths.begin(), paths.end(), [](const std::string& path) {
    std::error_code error;
    return path != "-" && std::filesystem::is_regular_file(path, error);
  });
}

}  // namespace host
