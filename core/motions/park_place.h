// Where the nozzle is parked when a print ends, and when it is stopped.
#pragma once

#include <algorithm>

#include "core/bed.h"       // Bed
#include "core/geometry.h"  // Point
#include "core/settings.h"  // Settings
#include "core/units.h"     // Length

namespace core {

// What parking keeps away from the bed's edge, where the user names no place.
inline constexpr Length kParkEdge = Length::from_units(50'000);

// From the bed's front left corner: park_x and park_y, within the bed; where they are not set, near
// that corner, which lies on every bed, however large it is taken to be. On a bed of another shape
// than a rectangle, the next place to it on the way to the bed's middle.
[[nodiscard]] inline Point park_place(const Settings& settings) {
  const auto along = [](Length asked, Length side) {
    const Length near = std::min(kParkEdge, Length::from_units(side.units() / 2));
    const Length at = asked < Length() ? near : std::min(asked, side);
    return static_cast<std::int32_t>(at.units());
  };
  const Point at{along(settings.park_x, settings.bed_x), along(settings.park_y, settings.bed_y)};
  if (settings.bed_shape.empty()) return at;
  const bool free = settings.park_x < Length() && settings.park_y < Length();
  return Bed(settings).place_near(at, free ? kParkEdge : Length());
}

}  // namespace core
