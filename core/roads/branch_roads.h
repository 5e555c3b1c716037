// The roads of a lightning fill's branches (supports/lightning_fold.h).
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings
#include "core/walls/branch.h"    // Branches

namespace core {

// A road for each branch, drawn on into the wall by loose_anchor where it meets it, as far as the
// wall is thick.
[[nodiscard]] std::vector<Road> branch_roads(const Branches& branches, const Settings& settings);

// Where their beads lie.
[[nodiscard]] Region branch_beads(const Branches& branches, const Settings& settings);

}  // namespace core
