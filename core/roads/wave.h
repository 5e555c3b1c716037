// A sine wave over the angle of a direction, and where it is below 0.
#pragma once

#include "core/vector.h"  // Vector, cross, dot

namespace core {

enum class Sign { kBelow, kAbove, kBoth };

// k + v · d for a direction d = (cos φ, sin φ): highest along v, lowest against it.
struct Wave {
  double k = 0;
  Vector v;

  [[nodiscard]] double at(Vector direction) const { return k + dot(v, direction); }

  // From one direction counter-clockwise to another, less than half a turn on: told by the values
  // there, unless the wave turns between them. kBoth: it may be of either sign.
  [[nodiscard]] Sign sign_between(Vector from, Vector to) const {
    const double turn_from = cross(from, v), turn_to = cross(to, v);
    const bool below = at(from) < 0 && at(to) < 0;
    const bool above = at(from) >= 0 && at(to) >= 0;
    if (below && !(turn_from > 0 && turn_to < 0)) return Sign::kBelow;
    if (above && !(turn_from < 0 && turn_to > 0)) return Sign::kAbove;
    return Sign::kBoth;
  }
};

}  // namespace core
