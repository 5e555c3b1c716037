// How speed and acceleration sink with the height, so that slender parts don't sway:
//
//     1 ───────╲
//               ╲
//     share      ╲───────
//           from   to     height
#pragma once

#include <algorithm>

#include "core/settings.h"  // Settings
#include "core/units.h"     // Length

namespace core {

// What is left at this height of a value of which `share` is left in the end.
[[nodiscard]] inline double height_share(const Settings& settings, Length height, double share) {
  const Length from = settings.height_slowdown_from, to = settings.height_slowdown_to;
  if (to <= from) return 1;
  const double way = std::clamp((height - from).mm() / (to - from).mm(), 0.0, 1.0);
  return 1 - way * (1 - share);
}

}  // namespace core
