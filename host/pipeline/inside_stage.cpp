#include "host/pipeline/inside_stage.h"

#include <fmt/format.h>

#include <atomic>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"         // subtract_within
#include "core/check.h"                    // RIND_CHECK
#include "core/offsets/slice_offsets.h"    // OffsetCutter
#include "core/walls/wall_style.h"         // window_decides
#include "host/part/branch_bytes.h"        // branch_bytes, branches_in
#include "host/pipeline/layer_batch.h"     // LayerBatch
#include "host/pipeline/ordered_stages.h"  // run_stages
#include "host/pipeline/slice_spool.h"     // next_slice, spooled

namespace host {
namespace {

constexpr SpillUse kForInside{"the inside", "name another folder with --spool"};

bool is_lightning(const core::Settings& settings) {
  return settings.loose_pattern == core::LoosePattern::kLightning;
}

// Of the first pass: no perimeters are laid there, and no seams.
core::Settings wall_alone(core::Settings settings) {
  settings.perimeters = 0;
  settings.seam = core::SeamPosition::kNearest;
  return settings;
}

}  // namespace

// Slices ─> offsets ─> window ─> two spools.
class InsideStage::FirstPass {
 public:
  FirstPass(InsideStage& stage, const Source& source, const Stopped& stopped, Told told)
      : stage_(stage),
        told_(told),
        source_(source),
        stopped_(stopped),
        cutter_(wall_alone(stage.settings_)),
        splitter_(stage.settings_) {}

  core::Status run(int threads) {
    const auto nothing = [](LayerBatch&) {};
    run_stages({.take = [this] { return take(); },
                .cut = [this](LayerBatch& batch) { cut(batch); },
                .split = [this](LayerBatch& batch) { split(batch); },
                .plan = nothing,
                .seams = nothing,
                .order = nothing,
                .give = [this](LayerBatch& batch) { give(batch); }},
               threads);
    stage_.window_ = splitter_.usage();
    return error_ ? core::Status(*error_) : core::Status();
  }

 private:
  std::unique_ptr<LayerBatch> take() {
    if (ended_ || failed_ || stopped_()) return nullptr;
    auto batch = std::make_unique<LayerBatch>();
    const StageMeter meter(Stage::kSlice, batch->use);
    core::Result<TakenSlice> taken = source_();
    if (!taken.ok()) {
      batch->error = taken.error();
      ended_ = true;
      return batch;
    }
    ended_ = !taken.value().slice;
    if (ended_) return batch;
    batch->slice = *std::move(taken.value().slice);
    told_.box.put({"inside: slicing", batch->slice->index + 1, told_.layers});
    batch->pause = std::move(taken.value().pause);
    batch->offsets = cutter_.reserve(*batch->slice);
    return batch;
  }

  void cut(LayerBatch& batch) {
    if (!batch.slice || !batch.offsets.to_fill) return;
    const StageMeter meter(Stage::kOffset, batch.use);
    batch.offset_retries = cutter_.fill(*batch.slice, *batch.offsets.offsets);
  }

  // In order.
  void split(LayerBatch& batch) {
    if (batch.error || failed_) return;
    const StageMeter meter(Stage::kWindow, batch.use);
    std::optional<core::SplitLayer> settled;
    if (!batch.slice) {
      while ((settled = splitter_.finish())) spool_inside(std::move(*settled), batch);
      return;
    }
    const core::Slice& slice = *batch.slice;
    const SpooledLayer layer =
        spooled(slice, std::make_shared<const core::Region>(slice.region), std::move(batch.pause));
    if (core::Status put = stage_.slices_->append(layer); !put.ok()) batch.error = put.error();
    settled = splitter_.push({*std::move(batch.slice), std::move(batch.offsets.offsets)});
    for (; settled; settled = splitter_.next()) spool_inside(std::move(*settled), batch);
  }

  void spool_inside(core::SplitLayer settled, LayerBatch& batch) {
    SpooledLayer layer;
    layer.index = settled.slice.index;
    layer.bottom = settled.slice.bottom;
    layer.height = settled.slice.height;
    layer.regions.front() = std::make_shared<const core::Region>(std::move(settled.loose));
    if (core::Status put = stage_.given_->append(layer); !put.ok()) batch.error = put.error();
  }

  // In order.
  void give(LayerBatch& batch) {
    stage_.offset_retries_ += batch.offset_retries;
    stage_.use_.boolean_retries += batch.use.boolean_retries;
    for (std::size_t i = 0; i < kStageCount; ++i) stage_.use_.seconds[i] += batch.use.seconds[i];
    if (!batch.error || error_) return;
    error_ = batch.error;
    failed_ = true;
  }

  InsideStage& stage_;
  Told told_;
  const Source& source_;
  const Stopped& stopped_;
  core::OffsetCutter cutter_;
  core::WallSplitter splitter_;
  bool ended_ = false;
  std::atomic<bool> failed_ = false;
  std::optional<core::Error> error_;
};

bool holds_its_roof(const core::Settings& settings) {
  return settings.loose_roof != core::LooseRoof::kOff || is_lightning(settings);
}

bool InsideStage::wanted() const {
  return holds_its_roof(settings_) && core::window_decides(settings_);
}

core::Status InsideStage::make_spools(WarningBox& warnings) {
  for (std::optional<LayerSpool>* spool : {&slices_, &given_, &decided_}) {
    core::Result<LayerSpool> made = LayerSpool::create(folder_, kForInside);
    if (!made.ok()) return made.error();
    *spool = std::move(made).value();
  }
  core::Result<RecordSpool> branches = RecordSpool::create(folder_, kForInside);
  if (!branches.ok()) return branches.error();
  branches_ = std::move(branches).value();
  if (slices_->file().in_memory()) {
    warnings.put(fmt::format(
        "the inside: {} is kept in memory, and with it the slices that are put there; --spool DIR "
        "puts them on a disk",
        slices_->file().folder()));
  }
  return {};
}

core::Status InsideStage::prepare(const Source& source, int threads, const Stopped& stopped,
                                  Told told) {
  RIND_CHECK(slices_.has_value());
  core::Status passed = FirstPass(*this, source, stopped, told).run(threads);
  if (!passed.ok() || stopped()) return passed;
  if (core::Status folded = fold(stopped, told); !folded.ok()) return folded;
  told.box.clear();
  slices_->read_forwards();
  decided_->read_backwards();
  branches_->go_to_end();
  return {};
}

core::Status InsideStage::fold(const Stopped& stopped, Told told) {
  const StageMeter meter(Stage::kWindow, use_);
  core::RoofFold fold(settings_);
  core::LightningFold lightning(settings_);
  given_->read_backwards();
  while (!stopped()) {
    core::Result<std::optional<SpooledLayer>> layer = given_->previous();
    if (!layer.ok()) return layer.error();
    if (!layer.value()) break;
    const SpooledLayer& found = *layer.value();
    if (told.layers <= found.index) told.layers = found.index + 1;  // the first one
    told.box.put({"inside: from the top down", told.layers - found.index, told.layers});
    fold.push({found.index, found.bottom, found.height, found.regions.front()});
    if (core::Status taken = take_decided(fold, lightning); !taken.ok()) return taken;
  }
  if (stopped()) return {};  // layer 0 was not reached
  fold.end();
  return take_decided(fold, lightning);
}

core::Status InsideStage::take_decided(core::RoofFold& fold, core::LightningFold& lightning) {
  while (std::optional<core::InsideLayer> found = fold.next()) {
    if (is_lightning(settings_)) {
      const std::string bytes = branch_bytes(lightning.push(*found));
      if (core::Status put = branches_->append(bytes); !put.ok()) return put;
    }
    SpooledLayer layer;
    layer.index = found->index;
    layer.regions.front() = found->loose;
    if (found->given != found->loose) layer.regions[1] = std::move(found->given);
    if (core::Status put = decided_->append(layer); !put.ok()) return put;
  }
  return {};
}

core::Result<TakenSlice> InsideStage::next_slice() {
  RIND_CHECK(slices_.has_value());
  return host::next_slice(*slices_);
}

core::Result<core::SplitLayer> InsideStage::split(core::Layer layer) {
  RIND_CHECK(decided_.has_value());
  while (!latest_ || latest_->index < layer.slice.index) {
    if (core::Status up = step_up(); !up.ok()) return up.error();
  }
  core::SplitLayer split;
  static_cast<core::Layer&>(split) = std::move(layer);
  split.loose = *latest_->regions.front();
  split.solid = core::subtract_within(split.slice.region, split.loose);
  split.window_loose = latest_->regions[1];
  split.branches = latest_branches_;
  split.below_branches = branches_below_;
  return split;
}

core::Status InsideStage::step_up() {
  core::Result<std::optional<SpooledLayer>> next = decided_->previous();
  if (!next.ok()) return next.error();
  RIND_CHECK(next.value().has_value());
  latest_ = *std::move(next.value());
  if (!is_lightning(settings_)) return {};
  core::Result<std::optional<RecordSpool::Record>> record = branches_->previous();
  if (!record.ok()) return record.error();
  RIND_CHECK(record.value().has_value());
  branches_below_ = std::move(latest_branches_);
  latest_branches_ = std::make_shared<const core::Branches>(branches_in(record.value()->bytes));
  return {};
}

std::int64_t InsideStage::spooled_bytes() const {
  std::int64_t bytes = branches_ ? branches_->size() : 0;
  for (const std::optional<LayerSpool>* spool : {&slices_, &given_, &decided_}) {
    if (*spool) bytes += (*spool)->bytes();
  }
  return bytes;
}

}  // namespace host
