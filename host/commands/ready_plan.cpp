#include "host/commands/ready_plan.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "host/commands/commands.h"   // part_title
#include "host/commands/print_run.h"  // space_in
#include "host/gcode/gcode_kind.h"
#include "host/pipeline/user_gcode.h"  // allowed_commands
#include "host/system/stage_clock.h"   // steady_seconds
#include "host/system/stop_signals.h"

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;

constexpr std::int64_t kBytesOfMB = 1'000'000;

Status scan(const PrintSettings& settings, ReadyFile& file, Reporter& reporter) {
  const Result<std::vector<std::string>> allowed = allowed_commands(settings.allow_gcode);
  if (!allowed.ok()) return allowed.error();
  const double began_s = steady_seconds();
  ScanRequest request;
  request.allowed = allowed.value();
  request.on_progress = [&](std::int64_t bytes) {
    const double now_s = steady_seconds();
    if (reporter.progress_due(now_s)) {
      ProgressReport report;
      report.preparation =
          Preparation{"checking the G-code", static_cast<core::LayerIndex>(bytes / kBytesOfMB),
                      static_cast<core::LayerIndex>(file.size() / kBytesOfMB), "MB"};
      report.elapsed_s = now_s - began_s;
      reporter.progress(report, now_s);
    }
    return stop_signal_count() == 0;
  };
  return file.scan(settings, request);
}

// Whether the roads lie on the bed, as far as the user has said how large it is.
Status check_bed(const ReadyFile& file, const MachineSpace& space) {
  const ReadySummary& summary = file.summary();
  const auto length = [](std::int32_t units) { return core::Length::from_units(units); };
  const core::Box& box = summary.box;
  if (!space.guessed && (box.min.x < 0 || box.min.y < 0 || length(box.max.x) > space.bed_x ||
                         length(box.max.y) > space.bed_y)) {
    return Error{
        ErrorCode::kOutOfBounds,
        fmt::format("{}: line {}: the roads reach from X {:g}, Y {:g} to X {:g}, Y {:g} mm "
                    "of the bed, which is {:g} by {:g} mm; slice it for this printer, or "
                    "check bed_x, bed_y and bed_origin_x, bed_origin_y",
                    file.name(), summary.outermost_line, length(box.min.x).mm(),
                    length(box.min.y).mm(), length(box.max.x).mm(), length(box.max.y).mm(),
                    space.bed_x.mm(), space.bed_y.mm())};
  }
  if (space.axis_z > core::Length() && summary.height > space.axis_z) {
    return Error{
        ErrorCode::kOutOfBounds,
        fmt::format("{}: line {}: roads are laid at {:g} mm, but axis_z is {:g} mm", file.name(),
                    summary.highest_line, summary.height.mm(), space.axis_z.mm())};
  }
  return {};
}

void tell(const PrintSettings& settings, const ReadyFile& file, Reporter& reporter) {
  const ReadySummary& summary = file.summary();
  reporter.note(
      "gcode",
      fmt::format("{}: ready G-code, printed as it is: {} commands, {} layers, {:.2f} m of "
                  "filament, {}{}",
                  part_title(file.name()), summary.commands, summary.layers,
                  summary.filament_mm / 1'000, duration_text(summary.time_s()),
                  summary.told_s ? " by its slicer" : " without heating"),
      {{"commands", summary.commands},
       {"layers", std::int64_t{summary.layers}},
       {"filament_mm", summary.filament_mm},
       {"seconds", summary.time_s()}});
  for (const std::string& warning : summary.warnings) reporter.note("warning", warning);
  for (const std::string& why : summary.unsafe) {
    reporter.note("warning",
                  "after a reset of the controller this print may not be resumed well: " + why);
  }
  if (!settings.start_gcode.empty() || !settings.end_gcode.empty() || !settings.at_height.empty()) {
    reporter.note("warning",
                  "start_gcode, end_gcode and at_height are left out: the file has its own lines");
  }
}

}  // namespace

Result<std::shared_ptr<ReadyFile>> open_ready(const Options& options) {
  const std::string& path = options.part.path;
  Result<InputFile> opened = InputFile::open(path);
  if (!opened.ok()) return opened.error();
  InputFile& file = opened.value();
  const Result<std::optional<GcodeKind>> kind = gcode_kind(file);
  if (!kind.ok()) return kind.error();
  const bool rereadable = file.rereadable();
  if (!kind.value()) {
    if (path == "-") InputFile::give_back(std::move(file));
    return std::shared_ptr<ReadyFile>();
  }
  if (*kind.value() == GcodeKind::kBinary) {
    return Error{ErrorCode::kBadPart,
                 file.name() + ": binary G-code can't be read yet; save it as plain .gcode"};
  }
  Result<FileBytes> bytes =
      rereadable ? FileBytes::open(path) : spooled(std::move(file), options.part.spool);
  if (!bytes.ok()) return bytes.error();
  return std::make_shared<ReadyFile>(std::move(bytes).value(), *kind.value() == GcodeKind::kBinary);
}

Result<PrintPlan> ready_plan(const Options& options, const PrintSettings& settings,
                             const std::shared_ptr<ReadyFile>& file, Reporter& reporter) {
  if (Status scanned = scan(settings, *file, reporter); !scanned.ok()) return scanned.error();
  if (Status fits = check_bed(*file, space_in(settings, options)); !fits.ok()) return fits.error();
  tell(settings, *file, reporter);
  PrintPlan print_plan{settings, OpenedPart{}, part_title(options.part.path)};
  print_plan.part.summary.format = "G-code";
  print_plan.part.summary.box = file->summary().box;
  print_plan.part.summary.height = file->summary().height;
  print_plan.part.summary.layers = file->summary().layers;
  print_plan.ready = file;
  return print_plan;
}

}  // namespace host
