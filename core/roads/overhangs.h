// How far the layer below holds perimeters.
//
//     ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒┆             share of a road's width over the slice below:
//     ════ the road ═══╪══════════        1/2 + d / w,   d: its centre line's depth inside
//     ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒┆  air
//
// A road is not cut where its share changes: it says for each of its segments how it is held
// (Road::holds), and gets a point where that changes. A road runs nearly along the contour below,
// or across it; the formula is right for the first, and for the second within half a width.
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings

namespace core {

// A road with this share of its width over the slice below is wholly held.
inline constexpr double kWhollyHeldShare = 0.9;

// Places that are looked at are at most this far apart where how a road is held may change.
inline constexpr Length kHoldStep = Length::from_units(2'000);

[[nodiscard]] Hold hold_of(double share);

// Sets the holds of the perimeters. Stretches shorter than a road is wide are held as what is
// beside them.
// COSTS: a walk along both slices where they agree; else a grid of the segments below, and some
// O(1) for each place.
void mark_holds(const Region& slice, const Region& below, const Settings& settings,
                std::vector<Road>& roads);

}  // namespace core
