// A queue of fixed capacity: first in, first out.
//
//     pop() <─ [oldest … newest] <─ push()
//
// Nothing in the program may grow with the part; what waits, waits in one of these.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/check.h"  // RIND_CHECK

namespace core {

template <typename T>
class RingBuffer {
 public:
  // A capacity of 0 is allowed: such a ring is always empty and full.
  // COSTS: the only allocation of the ring itself.
  explicit RingBuffer(std::size_t capacity) : slots_(capacity) {}

  [[nodiscard]] std::size_t capacity() const { return slots_.size(); }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] bool full() const { return size_ == slots_.size(); }

  // REQUIRES: !full()
  void push(T value) {
    RIND_CHECK(!full());
    slots_[slot(size_)] = std::move(value);
    ++size_;
  }

  // The oldest, or nothing when empty. ENSURES: what the value owned is no longer held here.
  [[nodiscard]] std::optional<T> pop() {
    if (empty()) return std::nullopt;
    std::optional<T> oldest = std::exchange(slots_[first_], std::nullopt);
    first_ = slot(1);
    --size_;
    return oldest;
  }

  // The oldest goes. REQUIRES: !empty()
  void drop() {
    RIND_CHECK(!empty());
    slots_[first_].reset();
    first_ = slot(1);
    --size_;
  }

  // Counted from the oldest. REQUIRES: i < size()
  [[nodiscard]] const T& operator[](std::size_t i) const {
    RIND_CHECK(i < size_);
    return *slots_[slot(i)];
  }
  [[nodiscard]] T& operator[](std::size_t i) {
    RIND_CHECK(i < size_);
    return *slots_[slot(i)];
  }

 private:
  // Where the i-th from the oldest lies; i <= size_, first_ < capacity, so one turn suffices.
  [[nodiscard]] std::size_t slot(std::size_t i) const {
    const std::size_t straight = first_ + i;
    return straight < slots_.size() ? straight : straight - slots_.size();
  }

  std::vector<std::optional<T>> slots_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

}  // namespace core
