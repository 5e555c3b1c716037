#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/raft_heights.h"
#include "host/commands/commands.h"
#include "host/commands/output_names.h"
#include "host/files/output_file.h"
#include "host/pipeline/inside_stage.h"  // holds_its_roof
#include "host/pipeline/user_gcode.h"
#include "host/printing/slow_layer_note.h"
#include "host/settings/whole_settings.h"
#include "host/system/exit_codes.h"
#include "host/system/stage_clock.h"
#include "host/system/stop_signals.h"

namespace host {

core::Result<PrintSettings> load_settings_of(const Options& options, Reporter& reporter) {
  core::Result<WholeSettings> whole = whole_settings(options.settings);
  if (!whole.ok()) return whole.error();
  const PrintSettings& settings = whole.value().settings;
  if (core::Status status = check_user_gcode(settings); !status.ok()) return status.error();
  for (const std::string& note : whole.value().notes) reporter.note("profile", note);
  for (const std::string& note : user_gcode_notes(settings)) reporter.note("warning", note);
  return settings;
}

namespace {

// Files of slices, and cuts, have no raft.
bool lays_whole_print(const Options& options) {
  if (options.subcommand == Subcommand::kSlice) {
    return options.output.format == OutputFormat::kGcode ||
           options.output.format == OutputFormat::kCliRoads;
  }
  return options.subcommand != Subcommand::kShow || !options.output.section;
}

// Cuts have the part with its supports.
bool lays_supports(const Options& options) {
  return lays_whole_print(options) || options.subcommand == Subcommand::kShow;
}

// The inside is empty, and the wall around it is as thin above as below.
bool leaves_roofs_unheld(const core::Settings& settings) {
  return settings.loose_density <= 0 && !holds_its_roof(settings) &&
         settings.style != core::BuildStyle::kRegular && !settings.spiral_vase;
}

}  // namespace

core::Result<PrintPlan> open_print_plan(const Options& options, Reporter& reporter) {
  core::Result<PrintSettings> settings = load_settings_of(options, reporter);
  if (!settings.ok()) return settings.error();
  if (settings.value().raft_layers > 0 && !lays_whole_print(options)) {
    core::Settings& of_part = settings.value();
    of_part = core::settings_above_raft(of_part);
    of_part.raft_layers = 0;
    reporter.note("raft", "the raft is left out here: the layers are the part's alone");
  }
  if (settings.value().supports != core::SupportPlace::kOff && !lays_supports(options)) {
    settings.value().supports = core::SupportPlace::kOff;
    reporter.note("supports", "supports are left out here: the layers are the part's alone");
  }
  const bool prints =
      options.subcommand == Subcommand::kPrint || options.subcommand == Subcommand::kResume;
  const bool sliced = options.subcommand == Subcommand::kSlice;
  OpenOptions open;
  open.sort_bytes = options.part.sort_bytes;
  if (options.memory_limit_bytes > 0) {
    const std::size_t quarter = std::max(kSortBytesMin, options.memory_limit_bytes / 4);
    open.sort_bytes = std::min(open.sort_bytes, quarter);
  }
  const bool supported = settings.value().supports != core::SupportPlace::kOff &&
                         settings.value().support_lookahead == 0;
  const bool whole = supported || holds_its_roof(settings.value());
  if (leaves_roofs_unheld(settings.value())) {
    reporter.note("inside",
                  "loose_density = 0: nothing holds what is laid over the inside; with "
                  "loose_roof = cone the wall does, with loose_pattern = lightning branches do");
  }
  open.stream_pipes = !whole && (options.part.sorted == PipeSorted::kYes ||
                                 (options.part.sorted == PipeSorted::kAuto && sliced));
  open.order_is_sure = options.part.sorted == PipeSorted::kYes;
  // The height was confirmed when the print was started.
  open.tall = options.part.tall || options.subcommand == Subcommand::kResume;
  OnBadLayer on_bad_layer = options.part.on_bad_layer;
  if (on_bad_layer == OnBadLayer::kPause && !prints) on_bad_layer = OnBadLayer::kStop;
  const bool ends = on_bad_layer == OnBadLayer::kStop;
  if (prints) open.plane_check = ends ? PlaneCheck::kRefuse : PlaneCheck::kWarn;
  // A print reads the rest of the part while it heats.
  core::Result<OpenedPart> part = prints
                                      ? open_part(options.part.path, settings.value(), open)
                                      : open_whole_part(options.part.path, settings.value(), open);
  if (!part.ok()) return part.error();
  const PartSummary& summary = part.value().summary;
  for (const std::string& warning : summary.warnings) reporter.note("warning", warning);
  return PrintPlan{std::move(settings).value(),
                   std::move(part).value(),
                   part_title(options.part.path),
                   on_bad_layer,
                   options.part.on_floating,
                   options.part.spool,
                   options.threads};
}

void connect_signals(PipelineSignals& signals, Reporter& reporter) {
  signals.stop_asked = [] { return stop_signal_count() > 0; };
  signals.on_slow_layer = [&reporter](const SlowLayer& slow) { tell_slow_layer(slow, reporter); };
  signals.preparation.on_put(
      [&reporter, began_s = steady_seconds()](const Preparation& preparation) {
        const double now_s = steady_seconds();
        if (!reporter.progress_due(now_s)) return;
        ProgressReport report;
        report.preparation = preparation;
        report.elapsed_s = now_s - began_s;
        reporter.progress(report, now_s);
      });
}

void report_warnings(PipelineSignals& signals, Reporter& reporter) {
  for (const std::string& warning : signals.warnings.take()) reporter.note("warning", warning);
}

void report_defects(const DefectLog& defects, Reporter& reporter) {
  if (defects.layers() == 0) return;
  reporter.note("defects", defects.summary(), {{"layers", defects.layers()}});
}

void report_hanging(const HangingLog& hanging, Reporter& reporter) {
  for (const std::string& line : hanging.summary()) reporter.note("hanging", line);
}

int save_statistics(const Options& options, const GeometryStatistics& geometry,
                    const LinkStatistics* link, int exit_code, Reporter& reporter) {
  if (options.stats.empty()) return exit_code;
  // The file at that name may have changed since the command was started.
  core::Status status = check_output_names(options);
  if (status.ok()) status = write_output(options.stats, statistics_json(geometry, link));
  if (status.ok()) return exit_code;
  const int failed = fail(status.error(), reporter);
  return exit_code == kExitDone ? failed : exit_code;
}

core::Status write_output(const std::string& path, const std::string& text) {
  core::Result<OutputFile> file = OutputFile::open(path);
  if (!file.ok()) return file.error();
  if (core::Status written = file.value().write(text); !written.ok()) return written;
  return file.value().commit(OutputFile::AfterStop::kWrite);
}

int show_result(const std::string& text, Reporter& reporter) {
  reporter.clear();
  const core::Status written = write_standard_output(text);
  return written.ok() ? kExitDone : fail(written.error(), reporter);
}

int stopped(const Options& options, Reporter& reporter) {
  reporter.error(stopped_message(options), kExitStopped);
  return kExitStopped;
}

std::string stopped_message(const Options& options) {
  if (options.output.path.empty()) return "stopped";
  if (options.output.path == "-") return "stopped; the output is not complete";
  return "stopped; " + options.output.path + " is not written";
}

int fail(const core::Error& error, Reporter& reporter) {
  // An error after a stop signal is caused by it.
  if (stop_signal_count() > 0) {
    reporter.error("stopped", kExitStopped);
    return kExitStopped;
  }
  reporter.error(error.message, kExitBadInput);
  return kExitBadInput;
}

std::string layer_words(const core::Settings& settings, const PartSummary& summary) {
  if (!core::has_unequal_layers(settings))
    return fmt::format("{:g} mm", settings.layer_height.mm());
  if (summary.highest_layer == core::Length()) return "unequal height";
  if (summary.highest_layer == summary.lowest_layer) {
    return fmt::format("{:g} mm", summary.lowest_layer.mm());
  }
  return fmt::format("{:g} to {:g} mm", summary.lowest_layer.mm(), summary.highest_layer.mm());
}

std::string part_title(const std::string& path) {
  return path == "-" ? "standard input" : std::filesystem::path(path).filename().string();
}

}  // namespace host
