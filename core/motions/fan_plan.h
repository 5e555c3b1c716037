// The fan along a layer: faster over bridges and overhangs than on the rest of it.
//
//     wanted  ▁▁▁▁▂▂▁▂▂▁▁▁▁▁▁▁▁▁▁▂▁▁▁▁▁      a run: ways beside each other that want more
//     planned ▁▁▁▁▂▂▂▂▂▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁
//                   ╰ near runs are one     ╰ a short one gets none: a fan does not follow so fast
//
// So the fan changes at most 2 · kFanRunsMax times in a layer: where there would be more runs,
// those nearest to one another are joined.
#pragma once

#include <cstddef>
#include <vector>

namespace core {

inline constexpr std::size_t kFanRunsMax = 8;
inline constexpr double kFanRunMin_mm = 5;   // a run lays at least as much
inline constexpr double kFanGapMin_mm = 25;  // between two runs at least as much is laid

// A way of the layer, in printing order, and the least share that it wants.
struct FanWish {
  double length_mm = 0;
  double share = 0;
};

// The share for each way: `layer_share`, or more. COSTS: O(ways · log).
[[nodiscard]] std::vector<double> fan_plan(double layer_share, const std::vector<FanWish>& ways);

}  // namespace core
