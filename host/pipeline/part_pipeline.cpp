#include "host/pipeline/part_pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

#include "core/offsets/slice_offsets.h"
#include "core/raft_heights.h"
#include "core/roads/layer_planner.h"
#include "core/walls/corners_ahead.h"
#include "core/walls/layer_neighbours.h"
#include "core/walls/loose_blocks.h"
#include "core/walls/wall_splitter.h"
#include "core/walls/wall_style.h"
#include "host/part/layer_rules.h"
#include "host/part/vase_layers.h"
#include "host/pipeline/command_stage.h"
#include "host/pipeline/floating_islands.h"
#include "host/pipeline/layer_batch.h"
#include "host/pipeline/layer_watch.h"
#include "host/pipeline/ordered_stages.h"
#include "host/pipeline/part_source.h"
#include "host/pipeline/pauses_ahead.h"
#include "host/pipeline/raft_stage.h"
#include "host/pipeline/run_end.h"
#include "host/system/memory_budget.h"

namespace host {
namespace {

class PartPipeline {
 public:
  PartPipeline(PrintPlan& print_plan, const PipelineOutputs& outputs, PipelineSignals& signals,
               GeometryStatistics& statistics, CommandStage& commands, std::atomic<bool>& refused)
      : plan_(print_plan),
        settings_(core::with_style(core::settings_above_raft(print_plan.settings))),
        outputs_(outputs),
        signals_(signals),
        statistics_(statistics),
        commands_(commands),
        run_(refused, signals.stop_asked),
        raft_(print_plan.settings, print_plan.start),
        source_(print_plan, settings_, signals, [this] { return run_.stopped(); }),
        supports_(source_.supports()),
        inside_(source_.inside()),
        watch_(signals.on_slow_layer, signals.slow_layer_s),
        cutter_(settings_),
        splitter_(settings_),
        ahead_(core::seam_layers_ahead(settings_)),
        blocks_(settings_),
        planner_(settings_),
        laid_(2 * static_cast<std::size_t>(core::loose_block_layers(settings_))),
        floating_(print_plan.on_floating, print_plan.part_path, signals.warnings) {
    plan_.part.layers =
        vase_layers(std::move(plan_.part.layers), settings_, plan_.part_path, signals_.warnings);
    if (print_plan.start) planner_.resume_from(print_plan.start->seams);
  }

  core::Result<PipelineEnd> run() {
    core::Result<PipelineEnd> end = run_in_memory();
    close_statistics();
    return end;
  }

 private:
  core::Result<PipelineEnd> run_in_memory() {
    try {
      if (core::Status ready = prepare(); !ready.ok()) return ready.error();
      run_stages({.take = [this] { return take(); },
                  .cut = [this](LayerBatch& batch) { cut(batch); },
                  .split = [this](LayerBatch& batch) { split(batch); },
                  .plan = [this](LayerBatch& batch) { plan(batch); },
                  .seams = [this](LayerBatch& batch) { place_seams(batch); },
                  .order = [this](LayerBatch& batch) { order(batch); },
                  .give = [this](LayerBatch& batch) { give(batch); }},
                 plan_.threads);
      return finish();
    } catch (const std::bad_alloc&) {
      return core::Error{core::ErrorCode::kNoMemory,
                         fmt::format("{}, layer {}: {}; allow more, or simplify the mesh",
                                     plan_.part_path, layer_at_hand(), memory_refusal())};
    }
  }

  // Counted from 1. Before the first layer, slices are taken for supports.
  [[nodiscard]] core::LayerIndex layer_at_hand() const {
    return (statistics_.layers > 0 ? statistics_.layers : source_.taken()) + 1;
  }

  core::Status prepare() {
    const auto preheat = [this] {
      if (outputs_.on_motion && !plan_.start) commands_.preheat();
    };
    core::Status prepared = source_.prepare(preheat, watch_);
    if (!plan_.turn) commands_.tell_objects(plan_.part.summary.objects, signals_.objects);
    commands_.allow_drafts();
    return prepared;
  }

  // Called in order. After the last slice it gives empty batches until the window is empty.
  std::unique_ptr<LayerBatch> take() {
    if (window_emptied_ || run_.stopped()) return nullptr;
    auto batch = std::make_unique<LayerBatch>();
    if (source_ended_) return batch;
    const StageMeter meter(Stage::kSlice, batch->use);
    if (core::Status taken = take_slice(*batch); !taken.ok()) batch->error = taken.error();
    source_ended_ = !batch->slice;
    return batch;
  }

  core::Status take_slice(LayerBatch& batch) {
    TakenSlice taken;
    do {
      core::Result<TakenSlice> next = source_.next_slice();
      if (!next.ok()) return next.error();
      taken = std::move(next).value();
      supports_.keep(taken.support, batch.supports);
      if (!taken.slice || run_.stopped()) return {};
    } while (plan_.start && is_far_below(*taken.slice, *raft_.start_in_part(), settings_));
    batch.pause = std::move(taken.pause);
    core::Slice& slice = *taken.slice;
    signals_.slices_cut.fetch_add(1);
    ++statistics_.layers;
    statistics_.defects.add(slice);
    batch.offsets = cutter_.reserve(slice);
    batch.slice = std::move(slice);
    return {};
  }

  // True for a layer below the start: it was printed before, and can't be split correctly here.
  [[nodiscard]] bool below_start(const core::SplitLayer& split) const {
    return plan_.start && split.slice.index < raft_.start_in_part()->layer;
  }

  void cut(LayerBatch& batch) {
    if (!batch.slice || !batch.offsets.to_fill) return;
    const StageMeter meter(Stage::kOffset, batch.use);
    const LayerWatch::Look look(watch_, batch.slice->index, batch.slice->top(),
                                &batch.slice->region, batch.watched_s);
    batch.offset_retries = cutter_.fill(*batch.slice, *batch.offsets.offsets);
  }

  // In order.
  void split(LayerBatch& batch) {
    if (batch.error) return;
    const StageMeter meter(Stage::kWindow, batch.use);
    supports_.see(std::move(batch.supports));
    if (!batch.slice) {
      ahead_.end();
      if (std::optional<core::SplitLayer> settled = splitter_.finish()) {
        return reserve(neighbours_.push(*std::move(settled)), batch);
      }
      window_emptied_ = true;
      return reserve(neighbours_.finish(), batch);
    }
    if (splitter_.next_index() == 0) splitter_.start_at(batch.slice->index);
    if (batch.pause) pauses_.put(batch.slice->index, *std::move(batch.pause));
    const LayerWatch::Look look(watch_, batch.slice->index, batch.slice->top(),
                                size_of(batch.slice->region), batch.watched_s);
    ahead_.see(batch.slice->index, batch.offsets.offsets->corners);
    core::Layer layer{*std::move(batch.slice), std::move(batch.offsets.offsets)};
    if (inside_.wanted()) return split_as_prepared(std::move(layer), batch);
    std::optional<core::SplitLayer> settled = splitter_.push(std::move(layer));
    for (; settled; settled = splitter_.next()) {
      reserve(neighbours_.push(*std::move(settled)), batch);
    }
  }

  void split_as_prepared(core::Layer layer, LayerBatch& batch) {
    core::Result<core::SplitLayer> split = inside_.split(std::move(layer));
    if (!split.ok()) return void(batch.error = split.error());
    reserve(neighbours_.push(std::move(split).value()), batch);
  }

  void reserve(std::optional<core::SplitLayer> settled, LayerBatch& batch) {
    if (settled) ahead_.push(*std::move(settled));
    while (std::optional<core::SplitLayer> layer = ahead_.next()) blocks_.push(*std::move(layer));
    if (window_emptied_) blocks_.end();
    while (std::optional<core::SplitLayer> layer = blocks_.next()) {
      if (below_start(*layer)) continue;
      SettledLayer next;
      next.index = layer->slice.index;
      next.bottom = layer->slice.bottom;
      if (supports_.wanted()) {
        core::Result<core::SupportPlanner::Reservation> found = supports_.reserve(*layer);
        if (!found.ok()) return void(batch.error = found.error());
        next.support = std::move(found).value();
      }
      next.reserved = planner_.reserve(*std::move(layer));
      next.pause = pauses_.take(next.index);
      batch.settled.push_back(std::move(next));
    }
  }

  LayerWatch::Look watched(const SettledLayer& settled, LayerBatch& batch) {
    const core::Slice& slice = settled.reserved.plan->split.slice;
    return {watch_, settled.index, settled.bottom + slice.height, &slice.region, batch.watched_s};
  }

  void plan(LayerBatch& batch) {
    const StageMeter meter(Stage::kRoads, batch.use);
    for (SettledLayer& settled : batch.settled) {
      const LayerWatch::Look look = watched(settled, batch);
      if (settled.support.to_fill) supports_.fill(*settled.support.plan);
      if (settled.reserved.to_fill) planner_.fill(*settled.reserved.plan, wants_roads());
    }
  }

  // In order.
  void place_seams(LayerBatch& batch) {
    if (!wants_roads()) return;
    const StageMeter meter(Stage::kSeams, batch.use);
    for (SettledLayer& settled : batch.settled) {
      settled.seams_before = std::make_shared<const core::SeamMemory>(planner_.seam_memory());
      settled.ordering = planner_.place_seams(settled.reserved.plan, settled.index);
      settled.laid = laid_.of(settled.ordering.roads, settled.support.plan.get());
    }
  }

  void order(LayerBatch& batch) {
    for (SettledLayer& settled : batch.settled) {
      if (settled.ordering.to_order) {
        const LayerWatch::Look look = watched(settled, batch);
        const StageMeter meter(Stage::kRoads, batch.use);
        planner_.order(*settled.reserved.plan, settled.ordering);
      }
      const StageMeter meter(Stage::kLay, batch.use);
      prepare(settled);
    }
  }

  void prepare(SettledLayer& settled) {
    settled.layer = settled.reserved.plan->layer;
    core::Slice& slice = settled.layer.slice;
    slice.index = settled.index;
    slice.bottom = settled.bottom;
    slice = raft_.lifted(std::move(slice));
    slice.index += layers_before();
    if (!outputs_.on_motion) return;
    const bool first = settled.ordering.to_order;
    if (first) settled.laid->prepare(commands_, slice, *settled.ordering.roads);
    // One thread makes a draft only of what a second layer lays: otherwise it gains nothing.
    if (first != (plan_.threads > 1)) return;
    settled.laid->prepare_draft(commands_, slice, settled.reserved.plan->travel_space.get());
  }

  // In order.
  void give(LayerBatch& batch) {
    if (run_.stopped()) return;
    if (batch.error) return run_.fail(*batch.error);
    {
      const StageMeter meter(Stage::kEncode, batch.use);
      for (SettledLayer& settled : batch.settled) {
        if (core::Status given = give(settled); !given.ok()) return run_.fail(given.error());
        if (run_.stopped()) return;
        settled.laid.reset();
      }
    }
    statistics_.retries.mountains += batch.offset_retries;
    statistics_.retries.booleans += batch.use.boolean_retries;
    statistics_.allocations.add(counts_.layers_timed, batch.use.allocations);
    const double computing_s = statistics_.clock.add_layer(batch.use.seconds);
    statistics_.layer_times.add(counts_.layers_timed++, computing_s);
    statistics_.pace.add(counts_.given, computing_s, commands_.seconds());
  }

  // Of the part; and before its first layer those of the raft.
  core::Status give(SettledLayer& settled) {
    if (settled.index == 0 && wants_roads()) {
      if (core::Status laid = give_raft(settled); !laid.ok() || run_.stopped()) return laid;
    }
    if (settled.pause && outputs_.on_pause) outputs_.on_pause(*settled.pause);
    const core::LayerPlan& plan = *settled.reserved.plan;
    const core::SplitLayer& layer = settled.layer;
    const core::Slice& slice = layer.slice;
    counts_.given = slice.index;
    statistics_.add_volume(layer, plan.regularised_mm3);
    if (core::Status held = floating_.check(slice, plan.hanging); !held.ok()) return held;
    statistics_.hanging.add(slice.index, slice.bottom, plan.hanging);
    run_.keep(outputs_.on_layer ? outputs_.on_layer(layer) : true);
    if (!wants_roads()) return {};
    const std::vector<core::Road>& roads = *settled.ordering.roads;
    counts_.part_roads += roads.size();
    LaidRoads& laid = *settled.laid;
    return lay(layer, {layer.slice, laid.with_supports(roads), laid.prepared(),
                       *settled.seams_before, plan.travel_space.get(), laid.draft()});
  }

  core::Status give_raft(const SettledLayer& settled) {
    const auto give = [&](const core::RaftLayer& laid) -> core::Status {
      if (run_.stopped()) return {};
      ++counts_.raft_layers;
      core::SplitLayer layer = laid.layer;
      layer.slice.index += layers_before();
      run_.keep(outputs_.on_layer ? outputs_.on_layer(layer) : true);
      return lay(layer, {layer.slice, laid.roads, nullptr, *settled.seams_before, nullptr});
    };
    return raft_.lay(settled.reserved.plan->layer, plan_.part_path, watch_, give);
  }

  core::Status lay(const core::SplitLayer& layer, const CommandStage::NextLayer& next) {
    const std::vector<core::Road>& roads = next.roads;
    core::Status fits = check_on_bed(plan_.part_path, layer.slice, roads, settings_);
    if (!fits.ok()) return fits;
    statistics_.roads += static_cast<std::int64_t>(roads.size());
    run_.keep(outputs_.on_roads ? outputs_.on_roads(layer, roads) : true);
    if (outputs_.on_motion) commands_.layer(next);
    const core::LayerIndex above = layer.slice.index + 1;
    if (plan_.turn && signals_.objects.left_out(plan_.turn->object, above)) run_.cancel();
    return {};
  }

  core::Result<PipelineEnd> finish() {
    if (run_.error()) return *run_.error();
    if (run_.only_cancelled()) return PipelineEnd::kDone;
    if (run_.stopped()) return PipelineEnd::kStopped;
    if (wants_roads() && counts_.part_roads == 0) {
      return no_road_fits(plan_.part_path, settings_);
    }
    return PipelineEnd::kDone;
  }

  void close_statistics() {
    source_.tell(statistics_, sliced_before_s_);
    statistics_.layers += counts_.raft_layers;
    const SlowLayers slow = watch_.slow_layers();
    statistics_.slow_layers.add(slow);
    if (const auto told = slow_layers_text(slow, signals_.slow_layer_s)) {
      signals_.warnings.put(*told);
    }
    const core::WallSplitter::Usage window =
        inside_.wanted() ? inside_.window() : splitter_.usage();
    statistics_.add_window(static_cast<std::int64_t>(window.layers_held_peak),
                           static_cast<std::int64_t>(window.regions_held_peak),
                           {window.operations, window.operations_worst});
    statistics_.add_reused({cutter_.reused(), window.layers_reused, planner_.reused()});
    statistics_.volumes.filament_density_g_mm3 = plan_.settings.filament_density_g_cm3 * 1e-3;
  }

  [[nodiscard]] core::LayerIndex layers_before() const {
    return plan_.turn ? plan_.turn->layers_before : 0;
  }
  [[nodiscard]] bool wants_roads() const { return outputs_.on_roads || outputs_.on_motion; }

  PrintPlan& plan_;
  const core::Settings settings_;
  const PipelineOutputs& outputs_;
  PipelineSignals& signals_;
  GeometryStatistics& statistics_;

  const double sliced_before_s_ = statistics_.clock.seconds(Stage::kSlice);
  CommandStage& commands_;
  RunEnd run_;

  RaftStage raft_;

  // Of take().
  PartSource source_;
  SupportStage& supports_;  // split() uses what of them take() does not
  InsideStage& inside_;
  LayerWatch watch_;           // of all stages
  core::OffsetCutter cutter_;  // cut() only reads its settings
  bool source_ended_ = false;

  // Of split().
  core::WallSplitter splitter_;
  core::LayerNeighbours neighbours_;
  core::CornersAhead ahead_;
  core::LooseBlocks blocks_;
  core::LayerPlanner planner_;  // plan() only reads its settings
  LaidRoadsMemory laid_;        // of place_seams()
  std::atomic<bool> window_emptied_ = false;
  PausesAhead pauses_;

  // Of give().
  FloatingIslands floating_;
  struct Counts {
    core::LayerIndex layers_timed = 0;
    core::LayerIndex raft_layers = 0;
    std::size_t part_roads = 0;
    core::LayerIndex given = 0;  // the last one
  } counts_;
};

}  // namespace

core::Result<PipelineEnd> run_part(PrintPlan& print_plan, const PipelineOutputs& outputs,
                                   PipelineSignals& signals, GeometryStatistics& statistics,
                                   CommandStage& commands, std::atomic<bool>& refused) {
  return PartPipeline(print_plan, outputs, signals, statistics, commands, refused).run();
}

}  // namespace host
