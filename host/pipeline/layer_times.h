// Median and worst of the layers' times, in constant memory.
//
// Times are counted in bins, each a twentieth wider than the one before, so the median is exact to
// 5 %:
//
//     1 µs ├┼┼─┼─┼──┼──┼───┼───┼ … ┤ over an hour
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/units.h"  // LayerIndex

namespace host {

class LayerTimes {
 public:
  void add(core::LayerIndex layer, double seconds);

  // 0 if no layer was counted. COSTS: O(bins).
  [[nodiscard]] double median_ms() const;
  [[nodiscard]] double worst_ms() const { return worst_s_ * 1e3; }
  [[nodiscard]] core::LayerIndex worst_layer() const { return worst_layer_; }

 private:
  static constexpr std::size_t kBins = 512;

  std::array<std::int64_t, kBins> counts_{};
  std::int64_t layers_ = 0;
  double worst_s_ = 0;
  core::LayerIndex worst_layer_ = 0;  // the first that took that long
};

}  // namespace host
