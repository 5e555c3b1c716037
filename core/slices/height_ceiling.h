// How high a layer may be at each height of a part: what the surface allows (height_limits.h),
// made gradual, so that a layer is hardly higher or lower than the one below.
//
//     highest ────╮                ╭────       c(z) = the least, over all bins, of the bin's limit
//                  ╲              ╱                   plus an eighth of the distance to it
//      1 in 8 ▸     ╲            ╱
//                    ╰──────────╯  a bin's limit
//
// A layer of the greatest height h with h <= c(z) between its bottom and its top is followed by one
// of at least h / (1 + 1/8) and at most h · (1 + 1/8), but for a step of rounding.
#pragma once

#include <cstdint>
#include <vector>

#include "core/slices/height_limits.h"  // HeightLimits
#include "core/units.h"                 // Length

namespace core {

// The ceiling rises and falls by one in so many.
inline constexpr std::int64_t kCeilingRun = 8;

class HeightCeiling {
 public:
  // The same everywhere.
  explicit HeightCeiling(Length height) : highest_(height) {}

  // `bed_z`: where the part's lowest point is in the heights that the limits were given.
  // COSTS: O(bins).
  HeightCeiling(const HeightLimits& limits, std::int64_t bed_z);

  // At this height above the bed. COSTS: O(1).
  [[nodiscard]] Length at(Length z) const;

  // The least between two heights. REQUIRES: from <= to. COSTS: O(bins between).
  [[nodiscard]] Length least(Length from, Length to) const;

  // Up to where it surely stays as it is at this height; `z` itself if that is not known.
  [[nodiscard]] Length level_until(Length z) const;

 private:
  // A bin's limit, and what those below it and above it leave at its lower and its upper edge.
  struct Bin {
    Length limit;
    Length below;
    Length above;
  };

  [[nodiscard]] Length bin_bottom(std::size_t bin) const {
    return bottom_ + Length::from_units(width_) * static_cast<std::int64_t>(bin);
  }
  [[nodiscard]] std::size_t bin_at(Length z) const {
    return static_cast<std::size_t>((z - bottom_).units() / width_);
  }
  [[nodiscard]] Length top() const { return bin_bottom(bins_.size()); }

  Length highest_;
  Length bottom_;           // of the lowest bin, above the bed
  std::int64_t width_ = 1;  // of a bin
  std::vector<Bin> bins_;
};

}  // namespace core
