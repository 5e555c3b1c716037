#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "host/commands/commands.h"
#include "host/exit_codes.h"
#include "host/layer_picture.h"
#include "host/output_file.h"
#include "host/pipeline.h"
#include "host/stop_signals.h"

namespace host {

int show_command(const Options& options, Reporter& reporter) {
  core::Result<Job> opened = open_job(options, reporter);
  if (!opened.ok()) return fail(opened.error(), reporter);
  Job& job = opened.value();
  const core::LayerIndex layers = job.part.summary.layers;
  if (options.layer > layers) {
    return fail(
        {core::ErrorCode::kOutOfBounds, fmt::format("{}: there is no layer {}; the highest is {}",
                                                    options.part, options.layer, layers)},
        reporter);
  }

  std::string svg;
  PipelineOutputs outputs;
  outputs.on_roads = [&](const core::SplitLayer& layer, const std::vector<core::Road>& roads) {
    if (layer.layer.slice.index + 1 == options.layer) {
      svg = draw_layer({part_title(options.part), &layer, &roads});
    }
    return svg.empty();
  };
  PipelineSignals signals;
  signals.stop_asked = [] { return stop_signal_count() > 0; };
  GeometryStatistics statistics;
  const core::Result<PipelineEnd> end = run_pipeline(job, outputs, signals, statistics);
  if (!end.ok()) return fail(end.error(), reporter);
  if (svg.empty()) {
    reporter.error("stopped; " + options.output + " is not written", kExitStopped);
    return kExitStopped;
  }

  core::Result<OutputFile> file = OutputFile::open(options.output);
  if (!file.ok()) return fail(file.error(), reporter);
  if (core::Status status = file.value().write(svg); !status.ok()) {
    return fail(status.error(), reporter);
  }
  if (core::Status status = file.value().commit(); !status.ok()) {
    return fail(status.error(), reporter);
  }
  reporter.note("done", fmt::format("{}: layer {} of {}", options.output, options.layer, layers),
                {{"output", options.output}});
  return save_statistics(options, statistics, nullptr, kExitDone, reporter);
}

}  // namespace host
