// How far a slice may lie beyond the one below and still be held by it.
#pragma once

#include "core/settings.h"  // Settings
#include "core/units.h"     // Length

namespace core {

// h · tan(overhang_angle), h: the distance of the two slices' planes; and what rounding may add.
// Finite for a right angle, too.
[[nodiscard]] Length overhang_reach(Length planes, const Settings& settings);

}  // namespace core
