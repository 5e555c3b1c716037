#include "host/commands/ready_plan.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "host/commands/commands.h"   // part_title
#include "host/commands/print_run.h"  // space_in
#include "host/commands/spool_check.h"
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
Status check_bed(const ReadyFile& file, const PrintSettings& settings, const MachineSpace& space) {
  const ReadySummary& summary = file.summary();
  const bool known = !space.guessed || !space.bed_shape.empty();
  if (known && summary.outside_line > 0) {
    const auto mm = [](std::int32_t units) { return core::Length::from_units(units).mm(); };
    const core::Box& box = summary.box;
    return Error{
        ErrorCode::kOutOfBounds,
        fmt::format("{}: line {}: a road lies beyond the bed; all of them reach from X {:g}, "
                    "Y {:g} to X {:g}, Y {:g} mm from its corner, and it is {:g} by {:g} mm; "
                    "slice the part for this printer, or check bed_x, bed_y and bed_origin_x, "
                    "bed_origin_y",
                    file.name(), summary.outside_line, mm(box.min.x), mm(box.min.y), mm(box.max.x),
                    mm(box.max.y), settings.bed_x.mm(), settings.bed_y.mm())};
  }
  if (space.axis_z > core::Length() && summary.height > space.axis_z) {
    return Error{
        ErrorCode::kOutOfBounds,
        fmt::format("{}: line {}: roads are laid at {:g} mm, but axis_z is {:g} mm", file.name(),
                    summary.highest_line, summary.height.mm(), space.axis_z.mm())};
  }
  return {};
}

// What is done to a part can't be done to a file.
Status check_as_it_is(const ReadyFile& file, const PrintSettings& settings) {
  const core::Settings plain;
  std::string asked;
  const auto add = [&asked](bool is_asked, const char* key) {
    if (is_asked) asked += (asked.empty() ? "" : ", ") + std::string(key);
  };
  add(settings.sequential, "sequential");
  add(settings.copies != plain.copies, "copies");
  add(settings.part_scale != plain.part_scale, "part_scale");
  add(settings.part_rotation != plain.part_rotation, "part_rotation");
  add(settings.part_mirror != plain.part_mirror, "part_mirror");
  add(settings.cut != plain.cut, "cut");
  if (asked.empty()) return {};
  return Error{ErrorCode::kBadSetting,
               fmt::format("{}: ready G-code is printed as it is, once; leave out {}, or print the "
                           "part itself",
                           file.name(), asked)};
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
  if (!settings.at_height.empty()) {
    reporter.note("warning", "at_height is left out: the file is printed as it is");
  }
}

}  // namespace

std::string assumed_limits_text(const PrintSettings& settings) {
  if (settings.limits_assumed.empty()) return {};
  return fmt::format("; the machine's limits are taken to be {}", settings.limits_assumed);
}

int plan_ready(const Options& options, const PrintSettings& settings,
               const std::shared_ptr<ReadyFile>& file, Reporter& reporter) {
  const Result<PrintPlan> plan = ready_plan(options, settings, file, reporter);
  if (!plan.ok()) return fail(plan.error(), reporter);
  const ReadySummary& summary = file->summary();
  const Result<std::optional<double>> left_mm = spool_left_mm(options, settings);
  if (!left_mm.ok()) return fail(left_mm.error(), reporter);
  const SpoolCheck spool =
      spool_check(left_mm.value().value_or(0), summary.needed_mm, summary.needed_to_change_mm);
  const auto mm = [](std::int64_t units) { return core::Length::from_units(units).mm(); };
  const core::Box& box = summary.box;
  const bool boxed = !box.empty();
  const double x_mm = boxed ? mm(std::int64_t{box.max.x} - box.min.x) : 0;
  const double y_mm = boxed ? mm(std::int64_t{box.max.y} - box.min.y) : 0;
  if (options.json) {
    nlohmann::ordered_json json = {{"format", "G-code"},
                                   {"commands", summary.commands},
                                   {"layers", summary.layers},
                                   {"x_mm", x_mm},
                                   {"y_mm", y_mm},
                                   {"height_mm", summary.height.mm()},
                                   {"filament_mm", summary.filament_mm},
                                   {"time_s", summary.time_s()},
                                   {"motion_clock_s", summary.clock_s},
                                   {"needed_mm", summary.needed_mm}};
    if (!settings.limits_assumed.empty()) json["limits_assumed"] = settings.limits_assumed;
    if (summary.needed_to_change_mm) json["needed_to_change_mm"] = *summary.needed_to_change_mm;
    if (left_mm.value()) {
      json["spool_left_mm"] = spool.left_mm;
      json["spool_enough"] = spool.enough();
    }
    return show_result(json.dump(2) + "\n", reporter);
  }
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "part       {} (ready G-code, {} commands)\n", part_title(file->name()),
                 summary.commands);
  fmt::format_to(out, "size       {:.2f} x {:.2f} x {:.2f} mm, with the roads' centres\n", x_mm,
                 y_mm, summary.height.mm());
  fmt::format_to(out, "layers     {}{}\n", summary.layers,
                 summary.marks ? ", as its comments tell" : ", by height");
  fmt::format_to(out, "filament   {:9.1f} mm in roads\n", summary.filament_mm);
  if (left_mm.value()) fmt::format_to(out, "spool      {}\n", spool_text(spool));
  if (summary.told_s) {
    fmt::format_to(out, "time       {}, as its slicer tells\n", duration_text(*summary.told_s));
  }
  fmt::format_to(out, "time       about {} by rind's motion clock, without heating up{}\n",
                 duration_text(summary.clock_s), assumed_limits_text(settings));
  return show_result(text, reporter);
}

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
  if (!options.part.more_paths.empty()) {
    return core::Error{core::ErrorCode::kBadPart,
                       path +
                           ": this is G-code, which is printed as it is, and alone; name no "
                           "other part beside it"};
  }
  Result<FileBytes> bytes =
      rereadable ? FileBytes::open(path) : spooled(std::move(file), options.part.spool);
  if (!bytes.ok()) return bytes.error();
  return std::make_shared<ReadyFile>(std::move(bytes).value(), *kind.value() == GcodeKind::kBinary);
}

Result<PrintPlan> ready_plan(const Options& options, const PrintSettings& settings,
                             const std::shared_ptr<ReadyFile>& file, Reporter& reporter) {
  if (Status plain = check_as_it_is(*file, settings); !plain.ok()) return plain.error();
  if (Status scanned = scan(settings, *file, reporter); !scanned.ok()) return scanned.error();
  if (Status fits = check_bed(*file, settings, space_in(settings, options)); !fits.ok())
    return fits.error();
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
