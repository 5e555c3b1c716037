// One axis of a grid: which cell a coordinate lies in.
//
// Even: all cells are equally wide, a power of two, so that a shift finds one. Crowded: the same
// cells, each cut again into as many equal ones as its share of the values needs. So detail in one
// spot of a huge plate does not fall into one cell.
//
//     even       |    |    |    |    |
//     crowded    |    |    |||||||||||    |
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace core {

class GridAxis {
 public:
  // From low on, `extent` units. REQUIRES: extent < 2^32, shift < 32.
  void set_even(std::int64_t low, std::uint64_t extent, std::uint32_t shift);

  // At most twice `cells_wanted` cells, narrower where there are more values.
  // REQUIRES: as above; values, at least one, within low … low + extent - 1.
  // COSTS: O(values + cells). Memory is kept.
  void set_crowded(std::int64_t low, std::uint64_t extent, std::uint32_t cells_wanted,
                   std::span<const std::int32_t> values);

  [[nodiscard]] std::uint32_t count() const { return count_; }
  [[nodiscard]] std::uint32_t index(std::int64_t value) const {
    const auto along = static_cast<std::uint32_t>(value - low_);
    const std::uint32_t even = along >> shift_;
    if (parts_.empty()) return even;
    const Part& part = parts_[even];
    return part.first + ((along - (even << shift_)) >> part.shift);
  }
  // Where a cell starts. REQUIRES: index <= count().
  [[nodiscard]] std::int64_t start(std::uint32_t index) const {
    return parts_.empty() ? low_ + (std::int64_t{index} << shift_) : starts_[index];
  }

 private:
  // An even cell that was cut again.
  struct Part {
    std::uint32_t first;  // of its cells
    std::uint32_t shift;  // how wide they are
  };

  std::int64_t low_ = 0;
  std::uint32_t shift_ = 0;
  std::uint32_t count_ = 0;
  std::vector<Part> parts_;  // none: even
  std::vector<std::int64_t> starts_;
  std::vector<std::uint32_t> shares_;  // room to work
};

}  // namespace core
