// Which of many pieces have something in common with a region of many pieces.
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region

namespace core {

// The pieces that meet `region`, in the same order; touching does not count.
// COSTS: sorting both by where they begin; a boolean of two small regions for pieces and rings
// whose boxes overlap. Near-linear where boxes are small beside the extent of all.
[[nodiscard]] std::vector<Region> pieces_that_meet(std::vector<Region> pieces,
                                                   const Region& region);

}  // namespace core
