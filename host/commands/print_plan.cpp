#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "core/raft_heights.h"
#include "host/commands/commands.h"
#include "host/commands/output_names.h"
#include "host/commands/ready_plan.h"
#include "host/files/output_file.h"
#include "host/part/object_sequence.h"
#include "host/part/plate.h"
#include "host/pipeline/inside_stage.h"  // holds_its_roof
#include "host/pipeline/user_gcode.h"
#include "host/printing/slow_layer_note.h"
#include "host/settings/whole_settings.h"
#include "host/system/exit_codes.h"
#include "host/system/stage_clock.h"
#include "host/system/stop_signals.h"

namespace host {

core::Result<WholeSettings> load_settings_of(const Options& options, Reporter& reporter) {
  core::Result<WholeSettings> whole = whole_settings(options.settings);
  if (!whole.ok()) return whole.error();
  const PrintSettings& settings = whole.value().settings;
  if (core::Status status = check_user_gcode(settings); !status.ok()) return status.error();
  for (const std::string& note : whole.value().notes) reporter.note("profile", note);
  if (!whole.value().pending.empty()) return whole;
  for (const std::string& note : user_gcode_notes(settings)) reporter.note("warning", note);
  return whole;
}

namespace {

// The top of the highest layer, which may lie above the part's.
core::Length top_of(const OpenedPart& part, const core::Settings& settings) {
  const core::LayerIndex raft = settings.raft_layers;
  const core::LayerIndex layers = part.summary.layers - raft;
  if (!part.placing || layers <= 0) return part.summary.height;
  const core::LayerHeights heights = part.placing().heights;
  return core::raft_lift(settings) + heights.bottom(layers - 1) + heights.height(layers - 1);
}

// Fills in what the user's G-code asks of the part.
core::Status fill_gcode(const Options& options, const OpenedPart& part, WholeSettings& whole,
                        Reporter& reporter) {
  if (whole.pending.empty()) return {};
  const PartSummary& summary = part.summary;
  PartFacts facts{title_of(options.part), core::Length(), summary.layers, summary.box};
  if (summary.layers > 0) facts.top = top_of(part, whole.settings);
  const std::size_t told = whole.notes.size();
  if (core::Status filled = fill_for_part(options.settings, facts, whole); !filled.ok()) {
    return filled;
  }
  if (core::Status fine = check_user_gcode(whole.settings); !fine.ok()) return fine;
  for (std::size_t i = told; i < whole.notes.size(); ++i) reporter.note("profile", whole.notes[i]);
  for (const std::string& note : user_gcode_notes(whole.settings)) reporter.note("warning", note);
  return {};
}

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

// A real nozzle is not sent to places that may lie beside the bed.
core::Status check_bed_is_known(const Options& options, const WholeSettings& whole) {
  if (options.subcommand != Subcommand::kPrint || options.link.port == "virtual" ||
      whole.bed_known) {
    return {};
  }
  return core::Error{core::ErrorCode::kBadSetting,
                     fmt::format("nothing says how large the printer's bed is: run rind setup "
                                 "--port {}, once; or name a preset (--preset NAME, rind presets "
                                 "lists them) or the bed (--set bed_x=MM --set bed_y=MM)",
                                 options.link.port)};
}

// The inside is empty, and the wall around it is as thin above as below.
bool leaves_roofs_unheld(const core::Settings& settings) {
  return settings.loose_density <= 0 && !holds_its_roof(settings) &&
         settings.style != core::BuildStyle::kRegular && !settings.spiral_vase;
}

// Pictures, and files of layers, have all objects in each layer.
bool follows_time(const Options& options) {
  if (options.subcommand == Subcommand::kShow) return false;
  return options.subcommand != Subcommand::kSlice || options.output.format == OutputFormat::kGcode;
}

// Of the whole bed.
core::Result<OpenedPart> opened(const Options& options, const core::Settings& settings,
                                const OpenOptions& open, bool rest_later) {
  const std::vector<std::string> paths = part_paths(options);
  const bool plate = is_plate(paths, settings);
  const bool in_turn = settings.sequential && follows_time(options);
  core::Result<OpenedPart> part = plate && in_turn ? open_sequence(paths, settings, open)
                                  : plate          ? open_plate(paths, settings, open)
                                                   : open_part(options.part.path, settings, open);
  // What a 3MF lays onto the bed is known when it was opened.
  if (part.ok() && !plate && in_turn && part.value().items > 1) {
    part = open_sequence(paths, settings, open);
  }
  return rest_later ? std::move(part) : read_whole(std::move(part));
}

}  // namespace

core::Result<PrintPlan> open_print_plan(const Options& options, Reporter& reporter,
                                        FacetObserver on_facet) {
  core::Result<WholeSettings> whole = load_settings_of(options, reporter);
  if (!whole.ok()) return whole.error();
  if (core::Status known = check_bed_is_known(options, whole.value()); !known.ok()) {
    return known.error();
  }
  PrintSettings& settings = whole.value().settings;
  const bool prints =
      options.subcommand == Subcommand::kPrint || options.subcommand == Subcommand::kResume;
  if (prints) {
    core::Result<std::shared_ptr<ReadyFile>> ready = open_ready(options);
    if (!ready.ok()) return ready.error();
    if (ready.value()) return ready_plan(options, settings, ready.value(), reporter);
  }
  if (settings.raft_layers > 0 && !lays_whole_print(options)) {
    core::Settings& of_part = settings;
    of_part = core::settings_above_raft(of_part);
    of_part.raft_layers = 0;
    reporter.note("raft", "the raft is left out here: the layers are the part's alone");
  }
  if (settings.supports != core::SupportPlace::kOff && !lays_supports(options)) {
    settings.supports = core::SupportPlace::kOff;
    reporter.note("supports", "supports are left out here: the layers are the part's alone");
  }
  const bool sliced = options.subcommand == Subcommand::kSlice;
  OpenOptions open;
  open.sort_bytes = options.part.sort_bytes;
  if (options.memory_limit_bytes > 0) {
    const std::size_t quarter = std::max(kSortBytesMin, options.memory_limit_bytes / 4);
    open.sort_bytes = std::min(open.sort_bytes, quarter);
  }
  const bool supported =
      settings.supports != core::SupportPlace::kOff && settings.support_lookahead == 0;
  const bool read_whole = supported || holds_its_roof(settings);
  if (leaves_roofs_unheld(settings)) {
    reporter.note("inside",
                  "loose_density = 0: nothing holds what is laid over the inside; with "
                  "loose_roof = cone the wall does, with loose_pattern = lightning branches do");
  }
  open.stream_pipes = !read_whole && (options.part.sorted == PipeSorted::kYes ||
                                      (options.part.sorted == PipeSorted::kAuto && sliced));
  open.order_is_sure = options.part.sorted == PipeSorted::kYes;
  // The height was confirmed when the print was started.
  open.tall = options.part.tall || options.subcommand == Subcommand::kResume;
  if (!settings.thumbnails.empty()) open.on_facet = std::move(on_facet);
  OnBadLayer on_bad_layer = options.part.on_bad_layer;
  if (on_bad_layer == OnBadLayer::kPause && !prints) on_bad_layer = OnBadLayer::kStop;
  const bool ends = on_bad_layer == OnBadLayer::kStop;
  if (prints) open.plane_check = ends ? PlaneCheck::kRefuse : PlaneCheck::kWarn;
  // A print reads the rest of the part while it heats, unless its G-code asks for it.
  const bool rest_later = prints && whole.value().pending.empty();
  core::Result<OpenedPart> part = opened(options, settings, open, rest_later);
  if (!part.ok()) return part.error();
  const PartSummary& summary = part.value().summary;
  for (const std::string& warning : summary.warnings) reporter.note("warning", warning);
  for (const std::string& one : part.value().modifiers) reporter.note("modifier", one);
  core::Status filled = fill_gcode(options, part.value(), whole.value(), reporter);
  if (!filled.ok()) return filled.error();
  return PrintPlan{std::move(settings),
                   std::move(part).value(),
                   title_of(options.part),
                   on_bad_layer,
                   options.part.on_floating,
                   options.part.spool,
                   threads_at_work(options.threads)};
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

std::string title_of(const PartOptions& part) {
  if (!part.title.empty()) return part.title;
  const std::size_t more = part.more_paths.size();
  const std::string first = part_title(part.path);
  return more == 0 ? first : fmt::format("{} and {} more", first, more);
}

std::vector<std::string> part_paths(const Options& options) {
  std::vector<std::string> paths = options.part.more_paths;
  paths.insert(paths.begin(), options.part.path);
  return paths;
}

std::string part_title(const std::string& path) {
  return path == "-" ? "standard input" : std::filesystem::path(path).filename().string();
}

}  // namespace host
