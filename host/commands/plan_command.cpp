#include <fmt/format.h>

#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motions/motion_clock.h"
#include "core/raft_heights.h"
#include "core/roads/brim.h"
#include "core/slices/standing.h"
#include "host/commands/commands.h"
#include "host/commands/ready_plan.h"
#include "host/commands/spool_check.h"
#include "host/output/gcode_summary.h"  // filament_grams
#include "host/pipeline/pipeline.h"
#include "host/pipeline/standing_text.h"
#include "host/system/exit_codes.h"
#include "host/system/stop_signals.h"

namespace host {
namespace {

// Of the whole filament: weight, plastic, price.
std::string weight_text(double filament_mm, const core::Settings& settings) {
  if (settings.filament_density_g_cm3 == 0) return " (of unknown weight)";
  const double weight = filament_grams(filament_mm, settings);
  std::string text = fmt::format(" {:8.2f} g ({}, {:g} g/cm3)", weight, settings.filament_type,
                                 settings.filament_density_g_cm3);
  if (settings.filament_cost_kg > 0) {
    text += fmt::format(", price {:.2f}", weight * 1e-3 * settings.filament_cost_kg);
  }
  return text;
}

std::string spaced(core::RoadKind kind) {
  std::string name = road_kind_name(kind);
  for (char& c : name) c = c == '_' ? ' ' : c;
  return name;
}

std::string model_text(const PrintSettings& settings) {
  const double told_mm_s2 = settings.default_acceleration_mm_s2;
  const core::MotionModel model = core::motion_model(settings);
  std::string corners = fmt::format("junction deviation {:g} mm", model.junction_deviation_mm);
  if (model.square_corner_mm_s > 0) {
    corners = fmt::format("{:g} mm/s through right angles", model.square_corner_mm_s);
  }
  if (model.jerks()) corners = fmt::format("jerk {:g} mm/s", model.jerk_mm_s[0]);
  const double limit_mm_s2 = model.acceleration_max_mm_s2[0];
  const double acceleration_mm_s2 = told_mm_s2 > 0 ? told_mm_s2 : model.acceleration_mm_s2;
  return fmt::format(
      "{:g} mm/s2{}{}, {}, look-ahead {} moves{}", acceleration_mm_s2,
      told_mm_s2 > 0 ? ", other kinds of roads as told" : "",
      limit_mm_s2 > 0 ? fmt::format(", of which the machine allows {:g}", limit_mm_s2) : "",
      corners, core::kLookAheadMoves, assumed_limits_text(settings));
}

SpoolCheck spool_of(double left_mm, const GeometryStatistics& statistics) {
  return spool_check(left_mm, statistics.needed.mm, statistics.needed.to_change_mm);
}

// As they are cancelled by.
std::string objects_text(const std::vector<PartObject>& objects) {
  constexpr std::size_t kNamedMax = 24;
  std::string text;
  for (std::size_t i = 0; i < objects.size() && i < kNamedMax; ++i) {
    text += fmt::format("{}{} {}", i > 0 ? ", " : "", i + 1, objects[i].name);
  }
  if (objects.size() > kNamedMax) text += fmt::format(" … {}", objects.size());
  return text;
}

// `left_mm`: on the spool.
std::string table(const Options& options, const PrintPlan& print_plan,
                  const GeometryStatistics& statistics, std::optional<double> left_mm) {
  std::string text;
  const auto out = std::back_inserter(text);
  const core::Box& box = print_plan.part.summary.box;
  const auto mm = [](std::int64_t units) { return core::Length::from_units(units).mm(); };
  const std::int64_t facets = print_plan.part.summary.facets;
  fmt::format_to(out, "part       {} ({}{})\n", title_of(options.part),
                 print_plan.part.summary.format,
                 facets > 0 ? fmt::format(", {} facets", facets) : "");
  if (!box.empty()) {
    fmt::format_to(out, "size       {:.2f} x {:.2f} x {:.2f} mm\n", mm(box.max.x - box.min.x),
                   mm(box.max.y - box.min.y),
                   (print_plan.part.summary.height - core::raft_lift(print_plan.settings)).mm());
  }
  const std::vector<PartObject>& objects = print_plan.part.summary.objects;
  if (!objects.empty()) fmt::format_to(out, "objects    {}\n", objects_text(objects));
  if (facets > 0) {
    fmt::format_to(out, "layers     {} of {}, wall {:g} mm", statistics.layers,
                   layer_words(print_plan.settings, print_plan.part.summary),
                   print_plan.settings.wall_thickness.mm());
    if (!core::has_unequal_layers(print_plan.settings)) {
      fmt::format_to(out, " = {} layers", core::wall_layers(print_plan.settings));
    }
    text += '\n';
  } else {
    fmt::format_to(out, "layers     {} of the file's own heights, wall {:g} mm\n",
                   statistics.layers, print_plan.settings.wall_thickness.mm());
  }
  if (const int raft = print_plan.settings.raft_layers; raft > 0) {
    fmt::format_to(out, "raft       {} of these layers; the part begins {:g} mm above the bed\n",
                   raft, core::raft_lift(print_plan.settings).mm());
  }
  const double volume = statistics.volumes.solid_mm3 + statistics.volumes.loose_mm3;
  fmt::format_to(out, "volume     {:.2f} cm3, of it wall {:.1f} %\n", volume / 1'000,
                 volume > 0 ? 100 * statistics.volumes.solid_mm3 / volume : 0);
  const double total = total_mm(statistics.filament_mm);
  fmt::format_to(out, "filament   {:9.1f} mm{}\n", total, weight_text(total, print_plan.settings));
  for (std::size_t i = 0; i < statistics.filament_mm.size(); ++i) {
    const double used = statistics.filament_mm[i];
    if (used == 0) continue;
    fmt::format_to(out, "  {:<16} {:9.1f} mm {:8.2f} g {:5.1f} %\n",
                   spaced(static_cast<core::RoadKind>(i)), used,
                   filament_grams(used, print_plan.settings), 100 * used / total);
  }
  if (statistics.volumes.regularised_mm3 > 0) {
    fmt::format_to(out, "  of it {:.2f} g solid only because the inside was too narrow there\n",
                   statistics.volumes.regularised_mm3 * statistics.volumes.filament_density_g_mm3);
  }
  if (left_mm) {
    fmt::format_to(out, "spool      {}\n", spool_text(spool_of(*left_mm, statistics)));
  }
  fmt::format_to(out, "time       about {}, without heating up ({})\n",
                 duration_text(statistics.time_s), model_text(print_plan.settings));
  fmt::format_to(out, "defects    {}\n",
                 statistics.defects.layers() == 0 ? "none" : statistics.defects.summary());
  const std::vector<std::string> hanging = statistics.hanging.summary();
  if (hanging.empty()) fmt::format_to(out, "hanging    nothing\n");
  for (const std::string& line : hanging) fmt::format_to(out, "hanging    {}\n", line);
  fmt::format_to(out, "held       at most {} layers, {} partial intersections, {} triangles\n",
                 statistics.peak_held.layers, statistics.peak_held.regions,
                 statistics.peak_held.triangles);
  return text;
}

// The statistics, with what the table tells of the part.
std::string json_of(const Options& options, const PrintPlan& print_plan,
                    const GeometryStatistics& statistics, std::optional<double> left_mm) {
  using Json = nlohmann::ordered_json;
  const PartSummary& part = print_plan.part.summary;
  const PrintSettings& settings = print_plan.settings;
  Json json = Json::parse(statistics_json(statistics, nullptr));
  json["part"] = {{"name", title_of(options.part)},
                  {"format", part.format},
                  {"facets", part.facets},
                  {"degenerate_facets", part.degenerate},
                  {"warnings", part.warnings}};
  for (const PartObject& object : part.objects) json["part"]["objects"].push_back(object.name);
  if (!part.box.empty()) {
    const auto mm = [](std::int64_t units) { return core::Length::from_units(units).mm(); };
    json["part"]["x_mm"] = mm(std::int64_t{part.box.max.x} - part.box.min.x);
    json["part"]["y_mm"] = mm(std::int64_t{part.box.max.y} - part.box.min.y);
    json["part"]["z_mm"] = (part.height - core::raft_lift(settings)).mm();
  }
  json["volume_mm3"] = statistics.volumes.solid_mm3 + statistics.volumes.loose_mm3;
  json["filament_type"] = settings.filament_type;
  if (settings.filament_density_g_cm3 > 0) {
    const double grams = filament_grams(total_mm(statistics.filament_mm), settings);
    json["filament_g"] = grams;
    if (settings.filament_cost_kg > 0) json["price"] = grams * 1e-3 * settings.filament_cost_kg;
  }
  if (!settings.limits_assumed.empty()) json["limits_assumed"] = settings.limits_assumed;
  if (const auto to_change_mm = statistics.needed.to_change_mm) {
    json["needed_to_change_mm"] = *to_change_mm;
  }
  if (left_mm) {
    const SpoolCheck check = spool_of(*left_mm, statistics);
    json["spool_left_mm"] = check.left_mm;
    json["spool_enough"] = check.enough();
  }
  return json.dump(2) + "\n";
}

// Whether the part stands, and whether this computer keeps up.
std::string outlook(const GeometryStatistics& statistics) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const std::string& line : standing_text(*statistics.standing)) {
    fmt::format_to(out, "stands     {}\n", line);
  }
  const std::string pace = pace_text(statistics.pace);
  if (!pace.empty()) fmt::format_to(out, "computing  {}\n", pace);
  return text;
}

// The same for programs that read events.
void tell_outlook(const GeometryStatistics& statistics, Reporter& reporter) {
  for (const std::string& line : standing_text(*statistics.standing)) {
    reporter.note("standing", line);
  }
  if (const std::string pace = pace_text(statistics.pace); !pace.empty()) {
    reporter.note("pace", pace, {{"behind", statistics.pace.behind()}});
  }
}

}  // namespace

int plan_command(const Options& options, Reporter& reporter) {
  const core::Result<std::shared_ptr<ReadyFile>> ready = open_ready(options);
  if (!ready.ok()) return fail(ready.error(), reporter);
  if (ready.value()) {
    const core::Result<WholeSettings> whole = load_settings_of(options, reporter);
    if (!whole.ok()) return fail(whole.error(), reporter);
    return plan_ready(options, whole.value().settings, ready.value(), reporter);
  }
  core::Result<PrintPlan> opened = open_print_plan(options, reporter);
  if (!opened.ok()) return fail(opened.error(), reporter);
  PrintPlan& print_plan = opened.value();
  const core::Result<std::optional<double>> left_mm = spool_left_mm(options, print_plan.settings);
  if (!left_mm.ok()) return fail(left_mm.error(), reporter);

  const double started_s = steady_seconds();
  PipelineOutputs outputs;
  core::Standing standing(core::brim_reach(print_plan.settings).mm());
  core::Length top;
  outputs.on_layer = [&](const core::SplitLayer& layer) {
    if (layer.slice.bottom < top) standing.next_object();
    top = layer.slice.top();
    standing.add(layer.slice);
    const double now = steady_seconds();
    ProgressReport report;
    report.layer = layer.slice.index + 1;
    report.layers = print_plan.part.summary.layers;
    report.height = layer.slice.top();
    report.elapsed_s = now - started_s;
    reporter.progress(report, now);
    return true;
  };
  // Motions are only timed and counted.
  outputs.on_motion = [](const auto&, const auto&) { return stop_signal_count() == 0; };
  outputs.on_roads_text = [](std::string_view) { return stop_signal_count() == 0; };
  PipelineSignals signals;
  connect_signals(signals, reporter);
  GeometryStatistics statistics;
  const core::Result<PipelineEnd> end = run_pipeline(print_plan, outputs, signals, statistics);
  report_warnings(signals, reporter);
  if (!end.ok()) return fail(end.error(), reporter);
  if (end.value() == PipelineEnd::kStopped) return stopped(options, reporter);
  statistics.standing = standing.report();
  if (options.json) tell_outlook(statistics, reporter);
  const int shown = show_result(
      options.json ? json_of(options, print_plan, statistics, left_mm.value())
                   : table(options, print_plan, statistics, left_mm.value()) + outlook(statistics),
      reporter);
  return save_statistics(options, statistics, nullptr, shown, reporter);
}

}  // namespace host
