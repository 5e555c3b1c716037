// How a layer is cooled: slowed down until it takes its least time, and blown at by the fan, the
// more the less time it takes. The rules are PrusaSlicer's.
//
//     layer's time   0 ······ layer_time_min_s ······ fan_below_layer_time_s ······
//     fan            fan_share      falls evenly to fan_share_min      fan_share_min, or off
//
// The time is that after slowing down. Outer perimeters are slowed down last, bridges never. Off,
// not fan_share_min, is a long layer where fan_always_on is not set. Without cool_short_layers
// nothing is slowed down, and the fan is fan_share_min or off throughout. Before fan_from_layer it
// is off, and up to fan_full_layer it grows evenly.
#pragma once

#include <vector>

#include "core/roads/road.h"  // Road
#include "core/settings.h"    // Settings
#include "core/units.h"       // LayerIndex

namespace core {

// Which roads are slowed down to gain time.
enum class Slowing {
  kFirst,
  kLast,   // where that of the others is not enough: outer perimeters, whose look depends on speed
  kNever,  // bridges, which sag where they are slow
};

// A stretch of road that is laid in one go.
struct LaidWay {
  double length_mm = 0;
  double speed_mm_s = 0;  // at full speed. REQUIRES: > 0
  Slowing slowing = Slowing::kFirst;
};

struct LayerCooling {
  // Speeds times this, but none below slowed_speed_min_mm_s.
  double slowdown = 1;       // Slowing::kFirst
  double last_slowdown = 1;  // Slowing::kLast
  double fan_share = 0;      // in whole percents
};

[[nodiscard]] double slowdown_of(const LayerCooling& cooling, Slowing slowing);

[[nodiscard]] Slowing slowing_of(RoadKind kind);

// By length over speed alone: acceleration only makes the layer longer than asked for.
[[nodiscard]] LayerCooling layer_cooling(const Settings& settings, LayerIndex index,
                                         double travelling_s, const std::vector<LaidWay>& ways);

// Rounded down, but for rounding errors.
[[nodiscard]] double in_whole_percents(double share);

// A road's speed on such a layer.
[[nodiscard]] double slowed_speed_mm_s(double full_mm_s, double slowdown, double slowest_mm_s);

// The fan on a layer that takes so long.
[[nodiscard]] double fan_share(const Settings& settings, LayerIndex index, double layer_s);

// The share of its speed that the fan may have on a layer at most: 0 before fan_from_layer, growing
// evenly up to fan_full_layer.
[[nodiscard]] double fan_growth(const Settings& settings, LayerIndex index);

}  // namespace core
