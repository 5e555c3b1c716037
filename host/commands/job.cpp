#include <algorithm>
#include <filesystem>
#include <utility>

#include "host/commands/commands.h"
#include "host/exit_codes.h"
#include "host/pipeline/motion_encoder.h"
#include "host/settings/settings_file.h"
#include "host/settings/settings_table.h"

namespace host {
namespace {

void report_ignored(const LoadedSettings& loaded, const std::string& path, Reporter& reporter) {
  if (loaded.ignored.empty()) return;
  reporter.note("profile", path + ": " + std::to_string(loaded.set_count) + " settings taken, " +
                               std::to_string(loaded.ignored.size()) +
                               " of no meaning here left out");
}

}  // namespace

core::Result<core::Settings> load_settings_of(const Options& options, Reporter& reporter) {
  core::Settings settings;
  if (!options.profile.empty()) {
    core::Result<LoadedSettings> loaded = load_settings(options.profile, settings);
    if (!loaded.ok()) return loaded.error();
    report_ignored(loaded.value(), options.profile, reporter);
    settings = std::move(loaded).value().settings;
  }
  for (const auto& [key, value] : options.assignments) {
    if (core::Status status = set_setting(settings, key, value); !status.ok()) {
      return status.error();
    }
  }
  if (core::Status status = validate_settings(settings); !status.ok()) return status.error();
  if (core::Status status = check_user_gcode(settings); !status.ok()) return status.error();
  return settings;
}

core::Result<Job> open_job(const Options& options, Reporter& reporter) {
  core::Result<core::Settings> settings = load_settings_of(options, reporter);
  if (!settings.ok()) return settings.error();
  const bool prints =
      options.subcommand == Subcommand::kPrint || options.subcommand == Subcommand::kResume;
  const bool sliced = options.subcommand == Subcommand::kSlice;
  OpenOptions open;
  open.sort_bytes = options.sort_bytes;
  if (options.memory_limit_bytes > 0) {
    const std::size_t quarter = std::max(kSortBytesMin, options.memory_limit_bytes / 4);
    open.sort_bytes = std::min(open.sort_bytes, quarter);
  }
  open.stream_pipes =
      options.sorted == PipeSorted::kYes || (options.sorted == PipeSorted::kAuto && sliced);
  open.order_is_sure = options.sorted == PipeSorted::kYes;
  OnBadLayer on_bad_layer = options.on_bad_layer;
  if (on_bad_layer == OnBadLayer::kPause && !prints) on_bad_layer = OnBadLayer::kStop;
  const bool ends = on_bad_layer == OnBadLayer::kStop;
  if (prints) open.plane_check = ends ? PlaneCheck::kRefuse : PlaneCheck::kWarn;
  // A print reads the rest with its heaters on already.
  core::Result<OpenedPart> part = prints ? open_part(options.part, settings.value(), open)
                                         : open_whole_part(options.part, settings.value(), open);
  if (!part.ok()) return part.error();
  const PartSummary& summary = part.value().summary;
  for (const std::string& warning : summary.warnings) reporter.note("warning", warning);
  return Job{std::move(settings).value(), std::move(part).value(), part_title(options.part),
             on_bad_layer, options.jobs};
}

void report_warnings(PipelineSignals& signals, Reporter& reporter) {
  for (const std::string& warning : signals.warnings.take()) reporter.note("warning", warning);
}

void report_defects(const DefectLog& defects, Reporter& reporter) {
  if (defects.layers() == 0) return;
  reporter.note("defects", defects.summary(), {{"layers", defects.layers()}});
}

int save_statistics(const Options& options, const GeometryStatistics& geometry,
                    const LinkStatistics* link, int exit_code, Reporter& reporter) {
  if (options.stats.empty()) return exit_code;
  const core::Status status = write_statistics(options.stats, statistics_json(geometry, link));
  if (status.ok()) return exit_code;
  const int failed = fail(status.error(), reporter);
  return exit_code == kExitDone ? failed : exit_code;
}

int fail(const core::Error& error, Reporter& reporter) {
  reporter.error(error.message, kExitBadInput);
  return kExitBadInput;
}

std::string part_title(const std::string& path) {
  return path == "-" ? "standard input" : std::filesystem::path(path).filename().string();
}

}  // namespace host
