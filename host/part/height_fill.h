// Finds stretches of a mesh's height without corners, in one pass, in any order, in constant
// memory: the height is divided into up to 128 bins, whose width doubles when the mesh outgrows
// them.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>

namespace host {

class HeightFill {
 public:
  void add(std::int64_t z) {
    const std::int64_t bin = z >> shift_;
    if (bin < first_ || bin > last_) return add_outside(z);
    filled_.set(static_cast<std::size_t>(bin - first_));
  }

  // The longest stretch without a corner, exact to a bin's width; low >= high if there is none.
  struct Stretch {
    std::int64_t low = 0;
    std::int64_t high = 0;
  };
  [[nodiscard]] Stretch longest_empty() const;

 private:
  static constexpr std::size_t kBins = 128;

  void add_outside(std::int64_t z);
  void widen();

  std::bitset<kBins> filled_;  // bit 0 is bin first_
  std::int64_t first_ = 0;     // bins are counted from height 0
  std::int64_t last_ = -1;
  int shift_ = 0;  // a bin is 2^shift_ units wide
};

}  // namespace host
