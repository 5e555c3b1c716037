// What of a slice hangs in the air: farther than a reach from the slice below, or an island over
// nothing.
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

// Offsets of the slice below are this exact.
inline constexpr Length kUnheldTolerance = Length::from_units(50);

// The part of `slice` that is farther than `reach` from `below`.
// COSTS: a walk along both where it proves that there is none; else an offset of what is below, and
// two booleans. REQUIRES: reach > kUnheldTolerance.
[[nodiscard]] Region unheld(const Region& slice, const Region& below, Length reach);

// Islands of the slice that lie over no part of the slice below.
// COSTS: for each island a boolean with the rings below that are near it.
[[nodiscard]] std::vector<Region> islands_in_air(const Region& slice, const Region& below);

// A piece of what is unheld that is so narrow that only rounding made it.
[[nodiscard]] bool is_hair(const Region& piece);

}  // namespace core
