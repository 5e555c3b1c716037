#include "host/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

#include "core/motion_builder.h"
#include "core/motion_clock.h"
#include "core/road_planner.h"
#include "core/slice_offsets.h"
#include "core/wall_splitter.h"
#include "core/wall_style.h"
#include "host/layer_rules.h"
#include "host/memory_budget.h"
#include "host/motion_encoder.h"

namespace host {
namespace {

double volume_mm3(const core::Region& region, core::Length height) {
  return region.area_mm2() * height.mm();
}

class Pipeline {
 public:
  Pipeline(Job& job, const PipelineOutputs& outputs, PipelineSignals& signals,
           GeometryStatistics& statistics)
      : job_(job),
        settings_(core::with_style(job.settings)),
        outputs_(outputs),
        signals_(signals),
        statistics_(statistics),
        bad_layers_(job.on_bad_layer, job.part_path, signals.warnings),
        cutter_(settings_),
        splitter_(settings_),
        style_(settings_),
        planner_(settings_),
        builder_(settings_),
        motion_clock_({settings_.acceleration_mm_s2, settings_.filament_acceleration_mm_s2,
                       settings_.junction_deviation_mm}),
        sink_([this](const core::Motion& motion) { send(motion); }) {}

  core::Result<PipelineEnd> run() {
    core::Result<PipelineEnd> end = feed_in_memory();
    close_statistics();
    return end;
  }

 private:
  core::Status read_rest() {
    if (job_.part.read_rest) {
      clock().enter(Stage::kRead);
      if (outputs_.on_motion) builder_.preheat(sink_);
      core::Result<PartSummary> summary = job_.part.read_rest();
      if (!summary.ok()) return summary.error();
      job_.part.summary = std::move(summary).value();
      job_.part.read_rest = nullptr;
      for (const std::string& warning : job_.part.summary.warnings) signals_.warnings.put(warning);
    }
    signals_.layers.store(job_.part.summary.layers);
    return {};
  }

  core::Result<PipelineEnd> feed_in_memory() {
    try {
      return feed();
    } catch (const std::bad_alloc&) {
      return core::Error{core::ErrorCode::kNoMemory,
                         fmt::format("{}, layer {}: {}; allow more, or simplify the mesh",
                                     job_.part_path, statistics_.layers + 1, memory_refusal())};
    }
  }

  core::Result<PipelineEnd> feed() {
    if (core::Status read = read_rest(); !read.ok()) return read.error();
    while (!stopped()) {
      clock().enter(Stage::kSlice);
      core::Result<std::optional<core::Slice>> next = job_.part.layers->next();
      if (!next.ok()) return next.error();
      if (!next.value().has_value()) return drain();
      core::Slice slice = *std::move(next).value();
      if (core::Status status = check_layer_height(job_.part_path, slice, settings_);
          !status.ok()) {
        return status.error();
      }
      if (core::Status status = bad_layers_.check(slice, job_.part.summary.layers); !status.ok()) {
        return status.error();
      }
      signals_.slices_cut.fetch_add(1);
      ++statistics_.layers;
      statistics_.defects.add(slice);

      clock().enter(Stage::kOffset);
      std::shared_ptr<const core::SliceOffsets> offsets = cutter_.cut(slice);
      clock().enter(Stage::kWindow);
      std::optional<core::SplitLayer> settled =
          splitter_.push({std::move(slice), std::move(offsets)});
      while (settled) {
        if (core::Status status = settle(*std::move(settled)); !status.ok()) return status.error();
        clock().enter(Stage::kWindow);
        settled = splitter_.next();
      }
      end_layer();
    }
    return PipelineEnd::kStopped;
  }

  core::Result<PipelineEnd> drain() {
    while (!stopped()) {
      clock().enter(Stage::kWindow);
      std::optional<core::SplitLayer> settled = splitter_.finish();
      if (!settled) break;
      if (core::Status status = settle(*std::move(settled)); !status.ok()) return status.error();
      end_layer();
    }
    if (stopped()) return PipelineEnd::kStopped;
    if (wants_roads() && statistics_.roads == 0) {
      return core::Error{
          core::ErrorCode::kBadPart,
          fmt::format("{}: no road fits anywhere: at every height the part is narrower than "
                      "road_width_min ({:g} mm); is it in millimetres?",
                      job_.part_path, settings_.road_width_min.mm())};
    }
    clock().enter(Stage::kEncode);
    if (outputs_.on_motion) builder_.finish(sink_);
    return stopped() ? PipelineEnd::kStopped : PipelineEnd::kDone;
  }

  core::Status settle(core::SplitLayer split) {
    const core::SplitLayer layer = style_.apply(std::move(split));
    const core::Slice& slice = layer.layer.slice;
    statistics_.solid_mm3 += volume_mm3(layer.solid, slice.height);
    statistics_.loose_mm3 += volume_mm3(layer.loose, slice.height);
    keep(outputs_.on_layer ? outputs_.on_layer(layer) : true);
    if (!wants_roads()) return {};

    clock().enter(Stage::kRoads);
    const std::vector<core::Road> roads = planner_.plan(layer);
    if (core::Status status = check_on_bed(job_.part_path, slice, roads, settings_); !status.ok())
      return status;
    statistics_.roads += static_cast<std::int64_t>(roads.size());
    keep(outputs_.on_roads ? outputs_.on_roads(layer, roads) : true);
    clock().enter(Stage::kEncode);
    if (outputs_.on_motion) builder_.layer(slice, roads, sink_);
    return {};
  }

  void send(const core::Motion& motion) {
    if (refused_) return;
    motion_clock_.add(motion);
    keep(outputs_.on_motion(motion, encoder_.encode(motion)));
  }

  void close_statistics() {
    clock().enter(Stage::kNone);
    const PartCounters used = job_.part.counters();
    clock().set_seconds(Stage::kRead, used.read_cpu_s);
    clock().set_seconds(Stage::kSort, used.sort_cpu_s);
    clock().set_seconds(Stage::kSlice, used.slice_cpu_s);
    statistics_.peak_triangles_held = used.peak_triangles_held;
    const core::WallSplitter::Usage window = splitter_.usage();
    statistics_.peak_layers_held = static_cast<std::int64_t>(window.layers_held_peak);
    statistics_.peak_regions_held = static_cast<std::int64_t>(window.regions_held_peak);
    statistics_.region_operations = window.operations;
    statistics_.region_operations_worst = window.operations_worst;
    statistics_.mountain_retries = cutter_.counters().retries;
    statistics_.reused = {cutter_.counters().reused, window.layers_reused,
                          planner_.layers_reused()};
    statistics_.regularised_mm3 = style_.regularised_mm3();
    statistics_.filament_mm = builder_.totals().filament_mm;
    statistics_.time_s = motion_clock_.seconds();
  }

  void end_layer() { statistics_.layer_times.add(layers_timed_++, clock().end_layer()); }

  [[nodiscard]] bool wants_roads() const { return outputs_.on_roads || outputs_.on_motion; }
  void keep(bool go_on) { refused_ = refused_ || !go_on; }
  [[nodiscard]] bool stopped() const {
    return refused_ || (signals_.stop_asked && signals_.stop_asked());
  }
  StageClock& clock() { return statistics_.clock; }

  Job& job_;
  const core::Settings settings_;
  const PipelineOutputs& outputs_;
  PipelineSignals& signals_;
  GeometryStatistics& statistics_;

  BadLayers bad_layers_;
  core::OffsetCutter cutter_;
  core::WallSplitter splitter_;
  core::WallStyle style_;
  core::RoadPlanner planner_;
  core::MotionBuilder builder_;
  core::MotionClock motion_clock_;
  MotionEncoder encoder_;
  core::MotionBuilder::Sink sink_;
  core::LayerIndex layers_timed_ = 0;
  bool refused_ = false;  // an output wants no more
};

}  // namespace

core::Result<PipelineEnd> run_pipeline(Job& job, const PipelineOutputs& outputs,
                                       PipelineSignals& signals, GeometryStatistics& statistics) {
  return Pipeline(job, outputs, signals, statistics).run();
}

}  // namespace host
