#include "host/commands/spool_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
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
                                  Reporter& quiet) {
  const core::Result<WholeSettings> whole = load_settings_of(options, quiet);
  if (!whole.ok()) return whole.error();
  const PrintSettings& settings = whole.value().settings;
  const core::Result<double> left_mm = spool_mm(*options.spool_left, settings);
  if (!left_mm.ok()) return left_mm.error();
  const core::Result<PrintPlan> plan = ready_plan(options, settings, file, quiet);
  if (!plan.ok()) return plan.error();
  return SpoolCheck{left_mm.value(), file->summary().needed_mm};
}

core::Result<SpoolCheck> planned(const Options& told, Reporter& reporter) {
  Options options = told;
  options.subcommand = Subcommand::kPlan;  // reads all
  // The print itself tells its notes.
  Reporter::Options silent;
  silent.quiet = true;
  Reporter quiet(silent);
  const core::Result<std::shared_ptr<ReadyFile>> ready = open_ready(options);
  if (!ready.ok()) return ready.error();
  if (ready.value()) return of_ready(options, ready.value(), quiet);
  core::Result<PrintPlan> opened = open_print_plan(options, quiet);
  if (!opened.ok()) return opened.error();
  PrintPlan& plan = opened.value();
  const core::Result<double> left_mm = spool_mm(*options.spool_left, plan.settings);
  if (!left_mm.ok()) return left_mm.error();
  SpoolCheck check{left_mm.value()};
  reporter.note("spool", "planning the whole print first, for --spool-left");
  PipelineOutputs outputs;
  outputs.on_motion = [](const auto&, const auto&) { return stop_signal_count() == 0; };
  PipelineSignals signals;
  connect_signals(signals, reporter);
  GeometryStatistics statistics;
  const core::Result<PipelineEnd> end = run_pipeline(plan, outputs, signals, statistics);
  if (!end.ok()) return end.error();
  check.needed_mm = statistics.needed_mm;
  return check;
}

// Whether the print may begin all the same.
bool consents(const std::string& what) {
  Controls controls(false);
  const std::optional<std::string> answer = controls.ask(
      what + "\np to print all the same, s to stop:", [] { return stop_signal_count() > 0; });
  return answer && trimmed(*answer) == "p";
}

}  // namespace

std::string spool_text(const SpoolCheck& check) {
  const double rest_mm = check.left_mm - check.needed_mm;
  return fmt::format("{} are left: {}", length_text(check.left_mm),
                     check.enough()
                         ? fmt::format("enough, {} stay on the spool", length_text(rest_mm))
                         : fmt::format("too short by {}", length_text(-rest_mm)));
}

core::Result<std::optional<double>> spool_left_mm(const Options& options,
                                                  const core::Settings& settings) {
  if (!options.spool_left) return std::optional<double>();
  const core::Result<double> left_mm = spool_mm(*options.spool_left, settings);
  if (!left_mm.ok()) return left_mm.error();
  return std::optional(left_mm.value());
}

std::optional<int> check_spool(const Options& options, Reporter& reporter) {
  if (!options.spool_left) return std::nullopt;
  if (!rereadable(options)) {
    reporter.note("warning",
                  "a part from a pipe can't be planned first: whether the spool is enough is not "
                  "known; what is left is counted down while it is printed");
    return std::nullopt;
  }
  const core::Result<SpoolCheck> check = planned(options, reporter);
  if (stop_signal_count() > 0) return stopped(options, reporter);
  if (!check.ok()) return fail(check.error(), reporter);
  const std::string text = fmt::format("the print needs {:.2f} m of filament; {}",
                                       check.value().needed_mm / 1'000, spool_text(check.value()));
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

bool rereadable(const Options& options) {
  const std::vector<std::string> paths = part_paths(options);
  return std::all_of(paths.begin(), paths.end(), [](const std::string& path) {
    std::error_code error;
    return path != "-" && std::filesystem::is_regular_file(path, error);
  });
}

}  // namespace host
