// Folds the last w values with an idempotent associative operation, in bounded work a step.
//
//     push(v_n) -> v_{n-w+1} ∘ … ∘ v_n       (nothing until w values have come)
//
// Method: doubling. The fold of the last 2, 4, 8 … values is made of two folds of half that width;
// the older of them was kept. The last two overlap, which an idempotent operation allows:
//
//     w = 7    1 │             ■     v_n
//              2 │           □ ■     □: the fold that was kept, ■: the one just made
//              4 │       □ □ ■ ■
//              7 │ □ □ □ □
//                │       ■ ■ ■ ■
//
// Every step costs the same. A queue of two stacks needs fewer operations on average, but
// sometimes a whole window of them in one step, and then the printer would wait.
// SOURCE: the sparse table for range minima (Bender and Farach-Colton 2000), made a stream.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/check.h"        // RIND_CHECK
#include "core/ring_buffer.h"  // RingBuffer

namespace core {

// REQUIRES: `combine(older, newer) -> Value` is associative, and combine(v, v) = v. It need not
// commute: older values always stand on the left.
template <typename Value, typename Combine>
class SlidingFold {
 public:
  // REQUIRES: window >= 1
  explicit SlidingFold(std::size_t window, Combine combine = Combine())
      : combine_(std::move(combine)) {
    RIND_CHECK(window >= 1);
    std::size_t width = 1;
    for (; 2 * width <= window; width *= 2) kept_.emplace_back(width);
    if (window > width) kept_.emplace_back(window - width);
  }

  // COSTS: at most ⌈log2(window)⌉ operations, on any call.
  [[nodiscard]] std::optional<Value> push(Value value) {
    operations_ = 0;
    for (RingBuffer<Value>& ring : kept_) {
      if (!ring.full()) {
        ring.push(std::move(value));
        ++partials_held_;
        return std::nullopt;
      }
      const std::optional<Value> older = ring.pop();
      Value wider = combine_(*older, std::as_const(value));
      ++operations_;
      ring.push(std::move(value));
      value = std::move(wider);
    }
    return value;
  }

  // Operations that the last push took.
  [[nodiscard]] int operations() const { return operations_; }
  // Folds that are kept, single values included. ENSURES: partials_held() < window.
  [[nodiscard]] std::size_t partials_held() const { return partials_held_; }

 private:
  Combine combine_;
  // kept_[k] holds the folds of 2^k values that ended 1 … size steps ago. Its oldest ends where the
  // newest starts; in the last ring it reaches down as far as the window does.
  std::vector<RingBuffer<Value>> kept_;
  int operations_ = 0;
  std::size_t partials_held_ = 0;
};

}  // namespace core
