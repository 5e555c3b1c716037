// A queue of fixed capacity without allocation: the oldest value leaves first.
//
//     pop() <── [0] [1] … [size() - 1] <── push()
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "firmware_link/wire/check.h"  // LINK_DCHECK

namespace firmware_link {

template <typename Value, std::size_t kCapacity>
class RingBuffer {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t room() const { return kCapacity - size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] bool full() const { return size_ == kCapacity; }

  // The value with `index` older ones before it. REQUIRES: index < size().
  [[nodiscard]] Value& operator[](std::size_t index) {
    LINK_DCHECK(index < size_);
    return values_[(first_ + index) % kCapacity];
  }
  [[nodiscard]] const Value& operator[](std::size_t index) const {
    LINK_DCHECK(index < size_);
    return values_[(first_ + index) % kCapacity];
  }

  // The oldest and the newest value. REQUIRES: !empty().
  [[nodiscard]] Value& front() { return (*this)[0]; }
  [[nodiscard]] const Value& front() const { return (*this)[0]; }
  [[nodiscard]] const Value& back() const { return (*this)[size_ - 1]; }

  // REQUIRES: !full().
  void push(Value value) {
    LINK_DCHECK(!full());
    values_[(first_ + size_++) % kCapacity] = std::move(value);
  }

  // Removes the oldest value. REQUIRES: !empty().
  Value pop() {
    Value value = std::move(front());
    first_ = (first_ + 1) % kCapacity;
    --size_;
    return value;
  }

  void clear() { size_ = 0; }

 private:
  std::array<Value, kCapacity> values_{};
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

}  // namespace firmware_link
