#include "core/booleans/grid_axis.h"

#include <algorithm>
#include <bit>

namespace core {

void GridAxis::set_even(std::int64_t low, std::uint64_t extent, std::uint32_t shift) {
  low_ = low;
  shift_ = shift;
  count_ = static_cast<std::uint32_t>(extent >> shift) + 1;
  parts_.clear();
}

void GridAxis::set_crowded(std::int64_t low, std::uint64_t extent, std::uint32_t cells_wanted,
                           std::span<const std::int32_t> values) {
  std::uint32_t shift = 0;
  while (((extent >> shift) + 1) > cells_wanted && shift < 31) ++shift;
  set_even(low, extent, shift);
  shares_.assign(count_, 0);
  for (const std::int32_t value : values) {
    ++shares_[static_cast<std::uint32_t>(value - low_) >> shift_];
  }
  starts_.clear();
  parts_.clear();
  std::uint32_t first = 0;
  for (std::uint32_t even = 0; even < shares_.size(); ++even) {
    const std::uint64_t cells = std::uint64_t{shares_[even]} * cells_wanted / values.size();
    const auto cuts = static_cast<std::uint32_t>(cells > 1 ? std::bit_width(cells) - 1 : 0);
    const std::uint32_t fine = shift_ - std::min(cuts, shift_);
    parts_.push_back({first, fine});
    const std::int64_t begin = low_ + (std::int64_t{even} << shift_);
    const std::uint32_t part_count = std::uint32_t{1} << (shift_ - fine);
    for (std::uint32_t i = 0; i < part_count; ++i) {
      starts_.push_back(begin + (std::int64_t{i} << fine));
    }
    first += part_count;
  }
  count_ = first;
  starts_.push_back(low_ + (static_cast<std::int64_t>(shares_.size()) << shift_));
}

}  // namespace core
