// Gap fill over a hollow inside: what of it nothing holds is left out.
//
//     ▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓       Where the wall gets thicker upwards over an inside that is empty, or
//        ▔▔╶───╴▔▔▔▔        nearly, the notches between two rows at its edge lie over nothing.
//                           A thin road in there would hang in the air.
#pragma once

#include <optional>
#include <vector>

#include "core/regions/point_location.h"  // PointLocation
#include "core/roads/road.h"              // Road
#include "core/settings.h"                // Settings
#include "core/units.h"                   // Length
#include "core/walls/split_layer.h"       // SplitLayer

namespace core {

// Longer stretches of gap fill in the air need to be held at both ends.
inline constexpr double kHollowStretchMax_mm = 0.6;

// Whether the inside has roads all over.
[[nodiscard]] bool has_pattern(const Settings& settings);

// Whether the inside is too empty for its roads to hold what is laid over it anywhere.
[[nodiscard]] bool has_hollow_inside(const Settings& settings);

class HollowEnds {
 public:
  // COSTS: O(points of the inside below).
  HollowEnds(const SplitLayer& layer, const Settings& settings);

  // Cuts off what ends in the air over the inside of the layer below.
  // COSTS: O(length of gap fill / road width · points of the inside in a strip).
  void cut(std::vector<Road>& roads) const;

 private:
  std::optional<PointLocation> hollow_;  // none: nothing to cut
  Length bridge_max_;
};

}  // namespace core
