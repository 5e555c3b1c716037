// The order of triangles by lowest z, without moving them. Those with the same lowest z keep their
// order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry.h"  // Triangle

namespace host {

class HeightOrder {
 public:
  // REQUIRES: fewer than 2^32.
  // COSTS: kBytesEach bytes a triangle, afterwards half of it. O(n) where heights are within 2^32
  // units (429 m): a radix sort, with no pass over digits that are all alike. Otherwise
  // O(n log n).
  void sort(const std::vector<core::Triangle>& triangles);

  // Frees the memory.
  void clear() { keys_ = {}; }

  // The triangle that comes i-th. REQUIRES: i < the number of triangles
  [[nodiscard]] std::size_t operator[](std::size_t i) const {
    return static_cast<std::uint32_t>(keys_[i]);
  }

  static constexpr std::size_t kBytesEach = 2 * sizeof(std::uint64_t);

 private:
  void sort_by_digits(std::uint64_t highest);

  std::vector<std::uint64_t> keys_;   // height above the lowest, and the triangle's number
  std::vector<std::uint64_t> spare_;  // a pass's result
};

}  // namespace host
