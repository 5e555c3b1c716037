// Sparse infill: fills the inside with a share of its volume, in few and long roads.
//
//     ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒     Lines of a pattern (fill_pattern.h) are clipped half a road's distance
//     ▒╭──╮  ╭──╮  ╭─╴─▒     inside the region, and joined there along its edge: the join's bead
//     ▒│  │  │  │  │   ▒     lies against the wall's. Ends that stay free are drawn on into the
//     ▒│  ╰──╯  ╰──╯   ▒     wall, so that it holds them.
//
// Joins are roads, too. With A the region's area, U the length of its contours where the lines end,
// and a the area of a bead over the layer's height, lines a distance p apart and joins along half
// of the contour lay the volume asked for when
//
//     A / p + U / 2 = density · A / a
//
// Rings at equal distances (concentric) are not lines of the plane: they are cut from the region.
//
// p is the nearest of a few steps, so that it changes seldom from layer to layer and rows lie over
// those below. The roads' width makes up for what is left. For the same reason a is that of a layer
// of layer_height where a mesh's layers differ in height.
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings
#include "core/slices/slice.h"    // Slice

namespace core {

// Whether a pattern is another one at every height, so that no layer's roads fit a later layer.
[[nodiscard]] bool changes_with_height(LoosePattern pattern);

// `inside`: what is to be filled; `within`: where centre lines may go that are drawn on.
// COSTS: O(points + lines · log), and an offset of the inside.
[[nodiscard]] std::vector<Road> loose_roads(const Region& inside, const Region& within,
                                            const Slice& slice, const Settings& settings);

}  // namespace core
