// How a layer is cooled: slowed down until it takes its least time, and blown at by the fan, the
// more the less time it takes. The rules are PrusaSlicer's.
//
//     layer's time   0 ······ layer_time_min_s ······ fan_below_layer_time_s ······
//     fan            fan_share      falls evenly to fan_share_min      fan_share_min, or off
//
// The time is that after slowing down. Off, not fan_share_min, is a long layer where fan_always_on
// is not set. Without cool_short_layers nothing is slowed down, and the fan is fan_share_min or off
// throughout. Before fan_from_layer it is off, and up to fan_full_layer it grows evenly.
#pragma once

#include <functional>
#include <vector>

#include "core/roads/road.h"  // Road, RoadKind
#include "core/settings.h"    // Settings
#include "core/units.h"       // LayerIndex

namespace core {

struct LayerCooling {
  double slowdown = 1;   // every speed times this, but none below slowed_speed_min_mm_s
  double fan_share = 0;  // in whole percents
};

// By length over speed alone: acceleration only makes the layer longer than asked for.
// `speed_mm_s`: of a kind of road on this layer, at full speed. REQUIRES: speeds above 0.
[[nodiscard]] LayerCooling layer_cooling(const Settings& settings, LayerIndex index,
                                         const std::vector<Road>& roads,
                                         const std::function<double(RoadKind)>& speed_mm_s);

// A road's speed on such a layer.
[[nodiscard]] double slowed_speed_mm_s(double full_mm_s, double slowdown, double slowest_mm_s);

// The fan on a layer that takes so long.
[[nodiscard]] double fan_share(const Settings& settings, LayerIndex index, double layer_s);

}  // namespace core
