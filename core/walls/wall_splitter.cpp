#include "core/walls/wall_splitter.h"

#include <algorithm>
#include <utility>

#include "core/check.h"

namespace core {

WallSplitter::WallSplitter(const Settings& settings)
    : wall_(std::in_place_type<BallWall>, settings.wall_thickness, settings.arc_tolerance) {
  if (wall_counts_layers(settings)) wall_.emplace<Cylinder>(wall_layers(settings));
}

void WallSplitter::start_at(LayerIndex first) {
  RIND_CHECK(next_index_ == 0 && first >= 0);
  next_index_ = first;
}

std::optional<SplitLayer> WallSplitter::push(Layer layer) {
  RIND_CHECK(layer.slice.index == next_index_);
  ++next_index_;
  if (auto* ball = std::get_if<BallWall>(&wall_)) {
    ball->push(std::move(layer));
    return next();
  }
  auto& cylinder = std::get<Cylinder>(wall_);
  // A copy: the layer keeps its offset, which later stages and pictures want to see.
  const std::vector<InnerOffset>& inners = layer.offsets->wall_inners;
  Region inner = inners.empty() ? Region() : inners.front().region;
  std::optional<Cylinder::Settled> settled = cylinder.push(std::move(layer), std::move(inner));
  operations_last_ = cylinder.operations();
  std::optional<SplitLayer> result = split(std::move(settled));
  RIND_CHECK(operations_last_ <= kFoldCostMax + 1);
  count_operations(operations_last_);
  return result;
}

std::optional<SplitLayer> WallSplitter::next() {
  auto* ball = std::get_if<BallWall>(&wall_);
  if (ball == nullptr) return std::nullopt;
  std::optional<SplitLayer> result = ball->next();
  if (result.has_value()) count_operations(ball->operations());
  return result;
}

std::optional<SplitLayer> WallSplitter::finish() {
  if (auto* ball = std::get_if<BallWall>(&wall_)) {
    ball->finish();
    return next();
  }
  operations_last_ = 0;
  return split(std::get<Cylinder>(wall_).finish());
}

std::optional<SplitLayer> WallSplitter::split(std::optional<Cylinder::Settled> settled) {
  if (!settled.has_value()) return std::nullopt;
  SplitLayer result{std::move(settled->item), {}, {}};
  if (settled->shared.has_value()) result.loose = *std::move(settled->shared);
  if (result.loose.empty()) {
    result.solid = result.slice.region;
  } else {
    result.solid = subtract(result.slice.region, result.loose);
    ++operations_last_;
  }
  return result;
}

void WallSplitter::count_operations(int operations) {
  operations_last_ = operations;
  operations_worst_ = std::max(operations_worst_, operations);
  operations_ += operations;
}

WallSplitter::Usage WallSplitter::usage() const {
  Usage usage;
  usage.operations_last = operations_last_;
  usage.operations_worst = operations_worst_;
  usage.operations = operations_;
  if (const auto* ball = std::get_if<BallWall>(&wall_)) {
    usage.layers_held = ball->layers_held();
    usage.layers_held_peak = ball->layers_held_peak();
    usage.layers_reused = ball->layers_reused();
    usage.offsets_cut = ball->offsets_cut();
    return usage;
  }
  const auto& cylinder = std::get<Cylinder>(wall_);
  usage.layers_held = cylinder.items_held();
  usage.layers_held_peak = cylinder.items_held_peak();
  usage.regions_held = cylinder.partials_held();
  usage.regions_held_peak = cylinder.partials_held();
  return usage;
}

}  // namespace core
