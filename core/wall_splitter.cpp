#include "core/wall_splitter.h"

#include <algorithm>
#include <utility>

#include "core/check.h"

namespace core {

std::optional<SplitLayer> WallSplitter::push(Layer layer) {
  RIND_CHECK(layer.slice.index == next_index());
  // A copy: the layer keeps its offset, which later stages and pictures want to see.
  Region inner = layer.offsets.wall_inner;
  std::optional<Window::Settled> settled = window_.push(std::move(layer), std::move(inner));
  operations_last_ = window_.operations();
  std::optional<SplitLayer> result = split(std::move(settled));
  RIND_CHECK(operations_last_ <= kFoldCostMax + 1);
  operations_worst_ = std::max(operations_worst_, operations_last_);
  return result;
}

std::optional<SplitLayer> WallSplitter::finish() {
  operations_last_ = 0;
  return split(window_.finish());
}

std::optional<SplitLayer> WallSplitter::split(std::optional<Window::Settled> settled) {
  if (!settled.has_value()) return std::nullopt;
  SplitLayer result;
  result.layer = std::move(settled->item);
  if (settled->shared.has_value()) result.loose = *std::move(settled->shared);
  if (result.loose.empty()) {
    result.solid = result.layer.slice.region;
  } else {
    result.solid = subtract(result.layer.slice.region, result.loose);
    ++operations_last_;
  }
  return result;
}

WallSplitter::Usage WallSplitter::usage() const {
  return {.layers_held = window_.items_held(),
          .layers_held_peak = window_.items_held_peak(),
          .regions_held = window_.partials_held(),
          .regions_held_peak = window_.partials_held(),
          .operations_last = operations_last_,
          .operations_worst = operations_worst_};
}

}  // namespace core
