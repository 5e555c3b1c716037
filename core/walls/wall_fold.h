// The window of a cylinder-shaped wall: when a layer is settled, and what all layers around it
// share.
//
//     shared(n) = inner(n-T) ∩ … ∩ inner(n+T),     inner(outside the part) = ∅
//
//     push(0 … T-1)   -> 0 … T-1, which share nothing: the part ends below them
//     push(T … 2T-1)  -> nothing
//     push(n >= 2T)   -> n-T
//     finish(), until it returns nothing -> the last T layers, which share nothing
//
// Layers and regions are template parameters, so that a test can run it on bitmasks against the
// definition (tests/core/walls/wall_fold_test.cpp). wall_splitter.h uses it on regions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/check.h"               // RIND_CHECK
#include "core/limits.h"              // kWallLayersMax
#include "core/ring_buffer.h"         // RingBuffer
#include "core/walls/sliding_fold.h"  // SlidingFold

namespace core {

// REQUIRES: Intersect is associative and idempotent, as sliding_fold.h states.
template <typename Item, typename Inner, typename Intersect>
class WallFold {
 public:
  struct Settled {
    Item item;
    std::optional<Inner> shared;  // nothing: the window reaches out of the part, so ∅
  };

  // REQUIRES: 1 <= wall_layers <= kWallLayersMax. wall_layers is T.
  explicit WallFold(int wall_layers)
      : wall_layers_(wall_layers),
        pending_(static_cast<std::size_t>(wall_layers) + 1),
        shared_(2 * static_cast<std::size_t>(wall_layers) + 1) {
    RIND_CHECK(wall_layers >= 1 && wall_layers <= kWallLayersMax);
  }

  // COSTS: at most ⌈log2(2T+1)⌉ intersections. REQUIRES: finish() was never called.
  [[nodiscard]] std::optional<Settled> push(Item item, Inner inner) {
    RIND_CHECK(!finished_);
    std::optional<Inner> shared = shared_.push(std::move(inner));
    const bool starts_part = pushed_ < wall_layers_;
    const bool window_full = pushed_ >= std::int64_t{2} * wall_layers_;
    RIND_CHECK(shared.has_value() == window_full);
    ++pushed_;
    if (starts_part) {
      items_held_peak_ = std::max<std::size_t>(items_held_peak_, 1);
      return Settled{std::move(item), std::nullopt};
    }
    pending_.push(std::move(item));
    items_held_peak_ = std::max(items_held_peak_, pending_.size());
    if (!window_full) return std::nullopt;
    return Settled{*pending_.pop(), std::move(shared)};
  }

  // No more items follow; the oldest that is still held, or nothing when all have left.
  [[nodiscard]] std::optional<Settled> finish() {
    finished_ = true;
    std::optional<Item> item = pending_.pop();
    if (!item.has_value()) return std::nullopt;
    return Settled{*std::move(item), std::nullopt};
  }

  // ENSURES: at most T between calls, T + 1 at the peak, which is within a push.
  [[nodiscard]] std::size_t items_held() const { return pending_.size(); }
  [[nodiscard]] std::size_t items_held_peak() const { return items_held_peak_; }
  // Partial intersections, at most 2T. They only become more: the count is its own peak.
  [[nodiscard]] std::size_t partials_held() const { return shared_.partials_held(); }
  // Intersections that the last push took.
  [[nodiscard]] int operations() const { return shared_.operations(); }

 private:
  int wall_layers_;
  std::int64_t pushed_ = 0;
  bool finished_ = false;
  RingBuffer<Item> pending_;
  std::size_t items_held_peak_ = 0;
  SlidingFold<Inner, Intersect> shared_;
};

}  // namespace core
