// What of a slice hangs in the air: farther than a reach from the slice below.
#pragma once

#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

// Offsets of the slice below are this exact.
inline constexpr Length kUnheldTolerance = Length::from_units(50);

// The part of `slice` that is farther than `reach` from `below`.
// COSTS: a walk along both where it proves that there is none; else an offset of what is below, and
// two booleans. REQUIRES: reach > kUnheldTolerance.
[[nodiscard]] Region unheld(const Region& slice, const Region& below, Length reach);

}  // namespace core
