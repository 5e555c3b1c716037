// How high a nozzle is lifted to leave the part: at the print's end, in a pause, in a stop.
#pragma once

#include <algorithm>

#include "core/settings.h"  // Settings
#include "core/units.h"     // Length

namespace core {

// By park_lift above `from`; never over the axis, never down.
[[nodiscard]] inline Length park_height(Length from, const Settings& settings) {
  Length height = from + settings.park_lift;
  if (settings.axis_z > Length()) height = std::min(height, settings.axis_z);
  return std::max(height, from);
}

}  // namespace core
