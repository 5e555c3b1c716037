// A whole print through the pipeline, with all that it gave.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/motions/motion.h"
#include "core/roads/road.h"
#include "core/settings.h"
#include "core/slices/slice.h"
#include "firmware_link/wire/line_codec.h"
#include "host/part/part_file.h"
#include "host/pipeline/pipeline.h"

namespace print_test {

struct Printed {
  std::vector<std::string> texts;
  std::vector<core::LayerStart> layers;
  std::vector<core::Slice> slices;             // of each layer given out
  std::vector<std::vector<core::Road>> roads;  // likewise
  std::vector<std::vector<core::Motion>> motions;
  core::LayerIndex layers_told = 0;
  std::vector<std::string> warnings;
  std::size_t preparations = 0;  // how often it was told
  host::GeometryStatistics statistics;
  std::string error;
};

// `spool`: PrintPlan::spool_folder.
inline Printed print(const core::Settings& settings, const std::string& path, int threads = 1,
                     const std::string& spool = "") {
  Printed printed;
  core::Result<host::OpenedPart> part = host::open_whole_part(path, settings);
  if (!part.ok()) {
    printed.error = part.error().message;
    return printed;
  }
  host::PrintPlan print_plan{settings, std::move(part).value(), "part"};
  print_plan.threads = threads;
  print_plan.spool_folder = spool;
  host::PipelineOutputs outputs;
  outputs.on_roads = [&](const core::SplitLayer& layer, const std::vector<core::Road>& roads) {
    printed.slices.push_back(layer.slice);
    printed.roads.push_back(roads);
    return true;
  };
  outputs.on_motion = [&](const core::Motion& motion,
                          const std::optional<firmware_link::Command>& command) {
    if (const auto* layer = std::get_if<core::LayerStart>(&motion)) {
      printed.layers.push_back(*layer);
      printed.motions.emplace_back();
    }
    if (!printed.motions.empty()) printed.motions.back().push_back(motion);
    firmware_link::TextBuffer buffer;
    if (command) printed.texts.emplace_back(firmware_link::encode(*command, buffer));
    return true;
  };
  host::PipelineSignals signals;
  signals.preparation.on_put([&](const host::Preparation&) { ++printed.preparations; });
  const auto end = host::run_pipeline(print_plan, outputs, signals, printed.statistics);
  if (!end.ok()) printed.error = end.error().message;
  printed.layers_told = signals.layers.load();
  printed.warnings = signals.warnings.take();
  return printed;
}

// How often a print asks whether to stop if it is told to after so many times, and how it ends.
struct StoppedPrint {
  int asked = 0;
  host::PipelineEnd end = host::PipelineEnd::kDone;
};

inline StoppedPrint print_stopped(const core::Settings& settings, const std::string& path,
                                  int stop_after) {
  core::Result<host::OpenedPart> part = host::open_whole_part(path, settings);
  REQUIRE(part.ok());
  host::PrintPlan print_plan{settings, std::move(part).value(), "part"};
  host::PipelineOutputs outputs;
  outputs.on_motion = [](const core::Motion&, const auto&) { return true; };
  host::PipelineSignals signals;
  StoppedPrint print;
  signals.stop_asked = [&] { return print.asked++ >= stop_after; };
  host::GeometryStatistics statistics;
  const auto end = host::run_pipeline(print_plan, outputs, signals, statistics);
  REQUIRE(end.ok());
  print.end = end.value();
  return print;
}

// A print that looks through its part before the first layer is asked once for each slice that is
// taken, and once for each that is folded: `times` or more.
inline void check_stops(const core::Settings& settings, const std::string& path, int times) {
  const StoppedPrint whole = print_stopped(settings, path, 1'000'000);
  CHECK(whole.end == host::PipelineEnd::kDone);
  REQUIRE_GT(whole.asked, times);
  for (int after = 0; after < times; after += 3) {
    CAPTURE(after);
    CHECK(print_stopped(settings, path, after).end == host::PipelineEnd::kStopped);
  }
}

}  // namespace print_test
