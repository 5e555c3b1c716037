#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/check.h"
#include "host/commands/commands.h"
#include "host/commands/thumbnails.h"
#include "host/files/output_file.h"
#include "host/formats/cli_writer.h"
#include "host/formats/lsif_writer.h"
#include "host/formats/slice_v0_writer.h"
#include "host/formats/svg_writer.h"
#include "host/output/gcode_summary.h"
#include "host/output/gcode_writer.h"
#include "host/output/part_view.h"
#include "host/pipeline/pipeline.h"
#include "host/system/exit_codes.h"
#include "host/system/stage_clock.h"
#include "host/system/stop_signals.h"
#include "host/system/version.h"

namespace host {
namespace {

// Null for G-code, which is written motion by motion.
std::unique_ptr<LayerWriter> layer_writer(const Options& options, const PrintPlan& print_plan) {
  LayerFileHead head;
  head.layers = print_plan.part.summary.layers;
  head.layer_height = print_plan.settings.layer_height;
  head.bed_x = print_plan.settings.bed_x;
  head.bed_y = print_plan.settings.bed_y;
  head.contents = options.output.contents;
  switch (options.output.format) {
    case OutputFormat::kGcode:
      return nullptr;
    case OutputFormat::kCli:
      return cli_writer(CliKind::kText, head);
    case OutputFormat::kCliBinary:
      return cli_writer(CliKind::kBinary, head);
    case OutputFormat::kCliRoads:
      return cli_writer(CliKind::kRoads, head);
    case OutputFormat::kLsif:
      return lsif_writer(head);
    case OutputFormat::kSliceV0:
      return slice_v0_writer(head);
    case OutputFormat::kSvg:
      return svg_writer(head);
  }
  return nullptr;
}

bool lays_road(const core::Motion& motion) {
  return std::holds_alternative<core::Extrude>(motion) ||
         std::holds_alternative<core::ExtrudeArc>(motion);
}

// Writes the pipeline's outputs to a file, and keeps the first error.
class SliceFile {
 public:
  // `pictures`: comments of a G-code file.
  SliceFile(const PrintPlan& print_plan, OutputFile file, std::unique_ptr<LayerWriter> layers,
            const std::string& pictures, GeometryStatistics& statistics, double started_s,
            Reporter& reporter)
      : plan_(print_plan),
        file_(std::move(file)),
        layers_(std::move(layers)),
        statistics_(statistics),
        started_s_(started_s),
        reporter_(reporter),
        gcode_(print_plan.settings.pause_gcode) {
    if (print_plan.settings.object_labels != core::ObjectLabels::kOff) {
      std::vector<std::string> names;
      for (const PartObject& object : print_plan.part.summary.objects) names.push_back(object.name);
      gcode_.name_objects(std::move(names));
    }
    if (layers_) {
      layers_->begin(text_);
    } else {
      text_ = gcode_head(kVersion, static_cast<std::int64_t>(std::time(nullptr))) + pictures;
      text_ += kStartsOwnGcode;
    }
  }

  [[nodiscard]] PipelineOutputs outputs() {
    PipelineOutputs outputs;
    const bool roads = layers_ && layers_->wants_roads();
    outputs.on_layer = [this, roads](const core::SplitLayer& layer) {
      report(layer.slice);
      return !layers_ || roads || take(layer, {});
    };
    if (roads) {
      outputs.on_roads = [this](const core::SplitLayer& layer,
                                const std::vector<core::Road>& laid) { return take(layer, laid); };
    }
    if (!layers_) {
      if (tells_progress()) {
        outputs.on_layer_time = [this](double seconds) {
          const auto offset = file_.position() + static_cast<std::int64_t>(text_.size());
          text_ += progress_.line_at(seconds, offset);
        };
      }
      outputs.on_motion = [this](const core::Motion& motion,
                                 const std::optional<firmware_link::Command>& command) {
        if (const auto* layer = std::get_if<core::LayerStart>(&motion)) {
          ++totals_.layers;
          totals_.height = layer->top;
        }
        if (command && std::holds_alternative<firmware_link::Verbatim>(*command)) {
          const std::string_view line = std::get<firmware_link::Verbatim>(*command).text();
          totals_.chamber_celsius = std::max(totals_.chamber_celsius, chamber_celsius_in(line));
        }
        gcode_.write(motion, command, text_);
        if (lays_road(motion)) note_road();
        return flush();
      };
      outputs.writer = &gcode_;
      outputs.on_roads_text = [this](std::string_view text) {
        note_road();
        return write(text);
      };
    }
    return outputs;
  }

  [[nodiscard]] core::Status commit() {
    if (layers_) layers_->end(text_);
    if (!layers_) end_gcode();
    if (!flush()) return status_;
    return file_.commit();
  }

  [[nodiscard]] const core::Status& status() const { return status_; }

 private:
  // Klipper knows M73 only with a section of its own in its configuration.
  [[nodiscard]] bool tells_progress() const {
    return plan_.settings.progress_commands && file_.patchable() &&
           plan_.settings.gcode_flavor != core::GcodeFlavor::kKlipper;
  }

  void end_gcode() {
    totals_.filament_mm = total_mm(statistics_.filament_mm);
    totals_.time_s = statistics_.time_s;
    text_ += gcode_tail(plan_.settings, totals_);
    if (!flush()) return;
    status_ = progress_.patch(totals_.time_s, [this](std::int64_t offset, std::string_view line) {
      return file_.patch(offset, line);
    });
  }

  bool take(const core::SplitLayer& layer, const std::vector<core::Road>& roads) {
    layers_->layer(layer, roads, text_);
    if (!roads.empty()) note_road();
    return flush();
  }

  void note_road() {
    if (statistics_.first_road_s) return;
    statistics_.first_road_s = steady_seconds() - started_s_;
    statistics_.first_road_cpu_s = process_cpu_seconds();
  }

  void report(const core::Slice& slice) {
    const double now = steady_seconds();
    ProgressReport report;
    report.layer = slice.index + 1;
    report.layers = plan_.part.summary.layers;
    report.height = slice.top();
    report.elapsed_s = now - started_s_;
    reporter_.progress(report, now);
  }

  bool flush() {
    const bool goes_on = write(text_);
    text_.clear();
    return goes_on;
  }

  bool write(std::string_view text) {
    if (status_.ok()) status_ = file_.write(text);
    return status_.ok() && stop_signal_count() == 0;
  }

  const PrintPlan& plan_;
  OutputFile file_;
  std::unique_ptr<LayerWriter> layers_;
  GeometryStatistics& statistics_;
  double started_s_;
  Reporter& reporter_;
  GcodeWriter gcode_;
  GcodeTotals totals_;
  ProgressLines progress_;
  std::string text_;
  core::Status status_;
};

void report_done(const Options& options, core::GcodeFlavor flavor,
                 const GeometryStatistics& statistics, Reporter& reporter) {
  std::string message = fmt::format("{}: {} layers", options.output.path, statistics.layers);
  if (options.output.format == OutputFormat::kGcode) {
    message +=
        fmt::format(", {:.2f} m of filament, about {}", total_mm(statistics.filament_mm) / 1'000,
                    duration_text(statistics.time_s));
    if (statistics.arcs > 0) {
      const bool klipper = flavor == core::GcodeFlavor::kKlipper;
      message += fmt::format(
          "; {} arcs (G2, G3), which {}: --set arcs=off", statistics.arcs,
          klipper ? "Klipper draws with [gcode_arcs] only" : "PrusaSlicer 2.5's viewer leaves out");
    }
  }
  reporter.note("done", message,
                {{"layers", statistics.layers},
                 {"filament_mm", total_mm(statistics.filament_mm)},
                 {"time_s", statistics.time_s},
                 {"output", options.output.path}});
}

}  // namespace

int slice_command(const Options& options, Reporter& reporter) {
  const double started_s = steady_seconds();
  core::Result<OutputFile> output = OutputFile::open(options.output.path);
  if (!output.ok()) return fail(output.error(), reporter);
  // Draws the part while it is read, if there is memory for it besides.
  std::optional<PartView> view;
  const bool gcode = options.output.format == OutputFormat::kGcode;
  const std::size_t limit = options.memory_limit_bytes;
  if (gcode && (limit == 0 || PartView::kBytes <= limit / 16)) view.emplace();
  core::Result<PrintPlan> opened =
      open_print_plan(options, reporter, [&view](const core::Triangle& facet) {
        if (view) view->add(facet);
      });
  if (!opened.ok()) return fail(opened.error(), reporter);
  PrintPlan& print_plan = opened.value();
  // Not everything that draws a file, or prints it, knows arcs.
  core::ArcUse& arcs = print_plan.settings.arcs;
  if (arcs == core::ArcUse::kAuto) arcs = core::ArcUse::kOff;

  if (view) draw_objects(print_plan, view);
  const std::string pictures = gcode ? thumbnail_comments(print_plan, view, reporter) : "";
  view.reset();

  GeometryStatistics statistics;
  SliceFile file(print_plan, std::move(output).value(), layer_writer(options, print_plan), pictures,
                 statistics, started_s, reporter);
  PipelineSignals signals;
  connect_signals(signals, reporter);
  const core::Result<PipelineEnd> end =
      run_pipeline(print_plan, file.outputs(), signals, statistics);
  report_warnings(signals, reporter);

  int exit_code = kExitDone;
  if (!end.ok()) {
    exit_code = fail(end.error(), reporter);
  } else if (!file.status().ok()) {
    exit_code = fail(file.status().error(), reporter);
  } else if (end.value() == PipelineEnd::kStopped) {
    exit_code = stopped(options, reporter);
  } else if (const core::Status status = file.commit(); !status.ok()) {
    exit_code = fail(status.error(), reporter);
  } else {
    report_defects(statistics.defects, reporter);
    report_hanging(statistics.hanging, reporter);
    report_done(options, print_plan.settings.gcode_flavor, statistics, reporter);
  }
  return save_statistics(options, statistics, nullptr, exit_code, reporter);
}

}  // namespace host
