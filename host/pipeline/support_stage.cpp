#include "host/pipeline/support_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/check.h"                 // RIND_CHECK
#include "core/supports/tree_fold.h"    // TreeFold
#include "core/supports/tree_reach.h"   // TreeReach
#include "host/pipeline/slice_spool.h"  // next_slice, spooled
#include "host/system/stage_clock.h"    // CpuTimer

namespace host {
namespace {

constexpr SpillUse kForSupports{"supports", "name another folder with --spool"};

// Null where nothing is marked.
std::shared_ptr<const core::SupportMarks> marks_in(const SpooledLayer& layer) {
  if (layer.regions[1]->empty() && layer.regions[2]->empty()) return nullptr;
  return std::make_shared<const core::SupportMarks>(
      core::SupportMarks{*layer.regions[1], *layer.regions[2]});
}

}  // namespace

core::Status SupportStage::make_spools(WarningBox& warnings) {
  core::Result<LayerSpool> slices = LayerSpool::create(folder_, kForSupports);
  if (!slices.ok()) return slices.error();
  core::Result<LayerSpool> supports = LayerSpool::create(folder_, kForSupports);
  if (!supports.ok()) return supports.error();
  slices_ = std::move(slices).value();
  supports_ = std::move(supports).value();
  if (slices_->file().in_memory()) {
    warnings.put(
        fmt::format("supports: {} is kept in memory, and with it the slices that are put there; "
                    "--spool DIR puts them on a disk",
                    slices_->file().folder()));
  }
  return {};
}

core::Status SupportStage::prepare(SliceIntake& intake, PreparationBox& told, LayerWatch& watch) {
  RIND_CHECK(slices_.has_value());
  if (core::Status spooled = spool_slices(intake, told); !spooled.ok()) return spooled;
  if (core::Status folded = fold(intake.taken(), told, watch); !folded.ok()) return folded;
  told.clear();
  slices_->read_forwards();
  supports_->read_backwards();
  return {};
}

core::Status SupportStage::spool_slices(SliceIntake& intake, PreparationBox& told) {
  core::TreeReach reach(settings_);
  while (!stopped_()) {
    core::Result<TakenSlice> taken = intake.next();
    if (!taken.ok()) return taken.error();
    if (!taken.value().slice) break;
    told.put({"supports: slicing", intake.taken(), intake.layers()});
    core::Slice& slice = *taken.value().slice;
    auto region = std::make_shared<const core::Region>(std::move(slice.region));
    SpooledLayer layer = spooled(slice, region, std::move(taken.value().pause));
    if (trees()) {
      const CpuTimer timer(seconds_);
      layer.regions[3] = reach.push(*region, slice.height);
    }
    if (slice.marks) {
      layer.regions[1] = {slice.marks, &slice.marks->enforced};
      layer.regions[2] = {slice.marks, &slice.marks->blocked};
    }
    if (core::Status written = slices_->append(layer); !written.ok()) return written;
  }
  return {};
}

core::Result<TakenSlice> SupportStage::next_slice(SliceIntake& intake, WarningBox& warnings) {
  if (!wanted()) return intake.next();
  if (ahead_) return ahead_->next(intake, stopped_, warnings);
  RIND_CHECK(slices_.has_value());
  return host::next_slice(*slices_);
}

core::Status SupportStage::fold(core::LayerIndex layers, PreparationBox& told, LayerWatch& watch) {
  const CpuTimer timer(seconds_);
  const auto slice_of = [](const SpooledLayer& layer) {
    return core::FoldSlice{layer.index, layer.bottom, layer.height, layer.regions.front(),
                           marks_in(layer)};
  };
  if (trees()) {
    core::TreeFold fold(settings_);
    return fold_down(
        fold, [&](const SpooledLayer& layer) { fold.push(slice_of(layer), layer.regions[3]); },
        layers, told, watch);
  }
  core::SupportFold fold(settings_);
  return fold_down(
      fold, [&](const SpooledLayer& layer) { fold.push(slice_of(layer)); }, layers, told, watch);
}

template <typename Fold, typename Push>
core::Status SupportStage::fold_down(Fold& fold, const Push& push, core::LayerIndex layers,
                                     PreparationBox& told, LayerWatch& watch) {
  slices_->read_backwards();
  while (!stopped_()) {
    core::Result<std::optional<SpooledLayer>> layer = slices_->previous();
    if (!layer.ok()) return layer.error();
    if (!layer.value()) break;
    const SpooledLayer& found = *layer.value();
    told.put({"supports: from the top down", layers - found.index, layers});
    double watched_s = 0;
    const LayerWatch::Look look(watch, found.index, found.bottom + found.height,
                                found.regions.front().get(), watched_s);
    const double before_s = thread_cpu_seconds();
    push(found);
    if (core::Status taken = take_decided(fold); !taken.ok()) return taken;
    worst_layer_s_ = std::max(worst_layer_s_, thread_cpu_seconds() - before_s);
  }
  if (stopped_()) return {};  // layer 0 was not reached
  fold.end();
  return take_decided(fold);
}

template <typename Fold>
core::Status SupportStage::take_decided(Fold& fold) {
  while (std::optional<core::SupportLayer> decided = fold.next()) {
    SpooledLayer layer;
    layer.index = decided->index;
    layer.height = decided->step;
    layer.regions = {decided->region, decided->interface, decided->branches, decided->feet};
    if (core::Status written = supports_->append(layer); !written.ok()) return written;
  }
  return {};
}

void SupportStage::keep(std::optional<core::SupportLayer>& support,
                        std::deque<core::SupportLayer>& supports) const {
  if (support) supports.push_back(*std::move(support));
  if (supports.size() > layers_kept()) supports.pop_front();
}

void SupportStage::see(std::deque<core::SupportLayer> supports) {
  for (core::SupportLayer& support : supports) seen_.push_back(std::move(support));
}

// From the bed up.
core::Result<core::SupportLayer> SupportStage::next_support() {
  if (ahead_) {
    RIND_CHECK(!seen_.empty());
    core::SupportLayer support = std::move(seen_.front());
    seen_.pop_front();
    return support;
  }
  RIND_CHECK(supports_.has_value());
  core::Result<std::optional<SpooledLayer>> next = supports_->previous();
  if (!next.ok()) return next.error();
  RIND_CHECK(next.value().has_value());
  SpooledLayer& found = *next.value();
  core::SupportLayer support{found.index,      found.regions[0], found.regions[1],
                             found.regions[2], found.regions[3], found.height};
  if (trees()) return standing_.standing(support);
  if (settings_.supports == core::SupportPlace::kBed) return columns_.standing(support);
  return support;
}

core::Result<core::SupportPlanner::Reservation> SupportStage::reserve(core::SplitLayer& layer) {
  while (recent_.empty() || recent_.back().index < layer.slice.index) {
    core::Result<core::SupportLayer> support = next_support();
    if (!support.ok()) return support.error();
    recent_.push_back(std::move(support).value());
    if (recent_.size() > layers_kept()) recent_.pop_front();
  }
  layer.support = recent_.back().region;
  if (layer.slice.index > 0) layer.support_below = recent_.front().region;
  return planner_.reserve(recent_.back(), layer.slice.height);
}

std::int64_t SupportStage::spooled_bytes() const {
  return slices_ ? slices_->bytes() + supports_->bytes() : 0;
}

}  // namespace host
