// What of a layer needs a support: the whole of what hangs, not only what is too far out.
//
//     ░░░░░░▓▓▓▓▓▓▓▓▓▓  slice     beyond h · tan(angle) it hangs; its strip from there back to
//     ░░░░░░┆     ┆               the slice below is held with it, so that the strips of all
//     ██████████──┘               layers of a slope touch one another
//     slice below
//
//     island      over no part of the slice below: it is held all over
//     overhang    held on one side at most, or by sides farther apart than bridge_max
//
// A span up to bridge_max is a bridge and needs none; of it, rows that are held at one end only do.
#pragma once

#include "core/regions/region.h"  // Region
#include "core/settings.h"        // Settings
#include "core/units.h"           // Length

namespace core {

// Disjoint; each lies in the slice and outside the slice below.
struct HangingRegions {
  Region islands;
  Region overhangs;

  [[nodiscard]] bool empty() const { return islands.empty() && overhangs.empty(); }
};

// `planes`: the distance of the two slices.
// COSTS: a walk along both where they nearly agree; else some offsets and booleans, and for each
// piece O(points + rows) for some directions.
[[nodiscard]] HangingRegions hanging_regions(const Region& slice, const Region& below,
                                             Length planes, const Settings& settings);

}  // namespace core
