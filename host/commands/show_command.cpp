#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/raft_heights.h"
#include "core/sections/layer_window.h"
#include "core/walls/wall_style.h"
#include "host/commands/commands.h"
#include "host/files/output_file.h"
#include "host/output/layer_picture.h"
#include "host/output/picture_file.h"
#include "host/output/picture_style.h"
#include "host/output/section_picture.h"
#include "host/pipeline/pipeline.h"
#include "host/system/exit_codes.h"

namespace host {
namespace {

// The asked layer, if it is the raft's: dense, or sparse.
std::string draw_raft_layer(const Options& options, const core::SplitLayer& layer,
                            const std::vector<core::Road>& roads, core::Settings settings) {
  settings.style = core::BuildStyle::kRegular;  // nothing decides which of it is dense
  core::LayerWindow window(settings);
  window.push(layer);
  window.finish();
  if (!window.next()) return {};
  return draw_layer({title_of(options.part), &window, &roads, layer_words(layer.slice, "raft")});
}

// The layer as the part alone has it, without what lies under it.
core::SplitLayer in_part(core::SplitLayer layer, const core::Settings& settings) {
  layer.slice.index -= settings.raft_layers;
  layer.slice.bottom -= core::raft_lift(settings);
  return layer;
}

// Waits for the layer's neighbours, which decide where its wall is.
int show_layer(const Options& options, PrintPlan& print_plan, PictureFile& file,
               Reporter& reporter) {
  const core::LayerIndex layers = print_plan.part.summary.layers;
  const auto no_such_layer = [&](core::LayerIndex highest) {
    return fail({core::ErrorCode::kOutOfBounds,
                 fmt::format("{}: there is no layer {}; the highest is {}", options.part.path,
                             options.output.layer, highest)},
                reporter);
  };
  // The number of layers is not always known before the end.
  if (layers > 0 && options.output.layer > layers) return no_such_layer(layers);
  std::string svg;
  std::vector<core::Road> roads_there;
  std::string words;
  const core::Settings settings =
      core::with_style(static_cast<const core::Settings&>(print_plan.settings));
  const core::LayerIndex raft = settings.raft_layers;
  core::LayerWindow window(settings);
  const auto draw = [&] {
    while (svg.empty() && window.next()) {
      if (window.layer().slice.index + raft + 1 != options.output.layer) continue;
      svg = draw_layer({title_of(options.part), &window, &roads_there, words});
    }
  };
  PipelineOutputs outputs;
  outputs.on_roads = [&](const core::SplitLayer& layer, const std::vector<core::Road>& roads) {
    const bool asked = layer.slice.index + 1 == options.output.layer;
    if (layer.slice.index < raft) {
      if (asked) svg = draw_raft_layer(options, layer, roads, settings);
      return svg.empty();
    }
    if (asked) {
      roads_there = roads;
      words = layer_words(layer.slice, wall_words(settings));
    }
    window.push(in_part(layer, settings));
    draw();
    return svg.empty();
  };
  PipelineSignals signals;
  connect_signals(signals, reporter);
  GeometryStatistics statistics;
  const core::Result<PipelineEnd> end = run_pipeline(print_plan, outputs, signals, statistics);
  report_warnings(signals, reporter);
  if (!end.ok()) return fail(end.error(), reporter);
  if (svg.empty() && end.value() == PipelineEnd::kDone) {
    window.finish();
    draw();
    if (svg.empty()) return no_such_layer(statistics.layers);
  }
  if (svg.empty()) return stopped(options, reporter);

  if (core::Status status = file.write(svg); !status.ok()) return fail(status.error(), reporter);
  if (core::Status status = file.commit(); !status.ok()) {
    return fail(status.error(), reporter);
  }
  report_hanging(statistics.hanging, reporter);
  reporter.note("done",
                fmt::format("{}: layer {}{}", options.output.path, options.output.layer,
                            layers > 0 ? fmt::format(" of {}", layers) : ""),
                {{"output", options.output.path}});
  return save_statistics(options, statistics, nullptr, kExitDone, reporter);
}

// The requested plane, in bed coordinates; an error if it misses the part.
core::Result<core::SectionLine> line_through(const SectionPlace& place, const core::Box& box,
                                             const std::string& part) {
  if (box.empty()) {
    return core::Error{core::ErrorCode::kBadPart,
                       part +
                           ": its extent is not known before its end, so it can't be cut; save "
                           "it to a file first"};
  }
  const bool across_y = place.axis == 'Y';
  const std::int64_t low = across_y ? box.min.y : box.min.x;
  const std::int64_t high = across_y ? box.max.y : box.max.x;
  const double size_mm = core::Length::from_units(high - low).mm();
  const double mm = place.percent ? place.value / 100 * size_mm : place.value;
  if (mm < 0 || mm > size_mm) {
    return core::Error{core::ErrorCode::kOutOfBounds,
                       fmt::format("{}: a cut at {}={:g} mm misses the part, which reaches from 0 "
                                   "to {:g} mm; {}=50% is its middle",
                                   part, place.axis, mm, size_mm, place.axis)};
  }
  // The line is half a unit above `at`, so it is inside even at the far side.
  const std::int64_t at = std::min(low + core::Length::from_mm(mm).units(), high - 1);
  return core::SectionLine{across_y ? core::SectionLine::Across::kY : core::SectionLine::Across::kX,
                           core::Length::from_units(at)};
}

// The requested square; an error if it misses the part.
core::Result<SectionPicture::View> view_of(const SectionZoom& zoom, const PartSummary& summary,
                                           const core::SectionLine& line, const std::string& part) {
  const bool across_y = line.across == core::SectionLine::Across::kY;
  const core::Box& box = summary.box;
  const std::int64_t edge = across_y ? box.min.x : box.min.y;
  const std::int64_t far_edge = across_y ? box.max.x : box.max.y;
  const double width_mm = core::Length::from_units(far_edge - edge).mm();
  const double half_mm = zoom.size / 2;
  if (zoom.along + half_mm <= 0 || zoom.along - half_mm >= width_mm || zoom.height + half_mm <= 0 ||
      zoom.height - half_mm >= summary.height.mm()) {
    return core::Error{
        core::ErrorCode::kOutOfBounds,
        fmt::format("{}: a square of {:g} mm around {:g} mm along the cut and {:g} mm "
                    "above the bed misses the part, which is {:g} mm wide there and "
                    "{:g} mm high",
                    part, zoom.size, zoom.along, zoom.height, width_mm, summary.height.mm())};
  }
  const auto units = [](double mm) { return core::Length::from_mm(mm).units(); };
  return SectionPicture::View{
      {edge + units(zoom.along - half_mm), edge + units(zoom.along + half_mm)},
      core::Length::from_mm(std::max(zoom.height - half_mm, 0.0)),
      core::Length::from_mm(zoom.height + half_mm)};
}

SectionPicture::Options picture_options(const Options& options, const PrintPlan& print_plan,
                                        const core::SectionLine& line) {
  const PartSummary& summary = print_plan.part.summary;
  const bool across_y = line.across == core::SectionLine::Across::kY;
  const std::int64_t low = across_y ? summary.box.min.y : summary.box.min.x;
  const double mm = core::Length::from_units(line.at.units() - low).mm();
  const std::string where = across_y
                                ? fmt::format("{:.4g} mm behind its front, seen from the front", mm)
                                : fmt::format("{:.4g} mm from its left, seen from the right", mm);
  SectionPicture::Options asked;
  asked.title = title_of(options.part);
  asked.subtitle =
      fmt::format("cut {}; {} layers of {}; {}", where, summary.layers,
                  layer_words(print_plan.settings, summary), wall_words(print_plan.settings));
  asked.line = line;
  asked.box = summary.box;
  asked.height = summary.height;
  asked.settings = core::with_style(static_cast<const core::Settings&>(print_plan.settings));
  return asked;
}

// Writes row by row, so memory does not grow with the part.
int show_section(const Options& options, PrintPlan& print_plan, PictureFile& file,
                 Reporter& reporter) {
  const core::Result<core::SectionLine> line =
      line_through(*options.output.section, print_plan.part.summary.box, options.part.path);
  if (!line.ok()) return fail(line.error(), reporter);
  SectionPicture::Options asked = picture_options(options, print_plan, line.value());
  if (options.output.zoom) {
    const core::Result<SectionPicture::View> view =
        view_of(*options.output.zoom, print_plan.part.summary, line.value(), options.part.path);
    if (!view.ok()) return fail(view.error(), reporter);
    asked.view = view.value();
  }
  SectionPicture picture(std::move(asked));
  core::LayerWindow window(
      core::with_style(static_cast<const core::Settings&>(print_plan.settings)));
  core::Status written = file.write(picture.start());
  const auto write = [&](const std::string& svg) {
    if (written.ok() && !svg.empty()) written = file.write(svg);
    return written.ok();
  };
  const auto draw = [&] {
    while (window.next()) {
      if (!write(picture.layer(window))) return false;
    }
    return true;
  };
  PipelineOutputs outputs;
  outputs.on_layer = [&](const core::SplitLayer& layer) {
    window.push(layer);
    return draw();
  };
  if (picture.shows_roads()) {
    outputs.on_roads = [&](const core::SplitLayer& layer, const std::vector<core::Road>& roads) {
      return write(picture.roads(layer.slice, roads));
    };
  }
  PipelineSignals signals;
  connect_signals(signals, reporter);
  GeometryStatistics statistics;
  const core::Result<PipelineEnd> end = run_pipeline(print_plan, outputs, signals, statistics);
  if (!end.ok()) return fail(end.error(), reporter);
  if (!written.ok()) return fail(written.error(), reporter);
  if (end.value() == PipelineEnd::kStopped) return stopped(options, reporter);
  window.finish();
  if (!draw() || !write(picture.end())) return fail(written.error(), reporter);
  if (core::Status status = file.commit(); !status.ok()) {
    return fail(status.error(), reporter);
  }
  report_hanging(statistics.hanging, reporter);
  reporter.note("done",
                fmt::format("{}: a cut through {} layers", options.output.path, statistics.layers),
                {{"output", options.output.path}});
  return save_statistics(options, statistics, nullptr, kExitDone, reporter);
}

}  // namespace

int show_command(const Options& options, Reporter& reporter) {
  core::Result<OutputFile> output = OutputFile::open(options.output.path);
  if (!output.ok()) return fail(output.error(), reporter);
  PictureFile file(std::move(output).value(),
                   picture_format_of(options.output.path).value_or(PictureFormat::kSvg));
  core::Result<PrintPlan> opened = open_print_plan(options, reporter);
  if (!opened.ok()) return fail(opened.error(), reporter);
  return options.output.section ? show_section(options, opened.value(), file, reporter)
                                : show_layer(options, opened.value(), file, reporter);
}

}  // namespace host
