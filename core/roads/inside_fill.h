// Fills the inside where some of it is to be filled otherwise (Slice::areas):
//
//     ┌────────────┬──────┐     each area takes what of the inside is within it (changed_areas.h)
//     │ ╱   ╱   ╱  │╱╱╱╱╱╱│     roads end at the border between two areas, half a road before it
//     │╱   ╱   ╱   │╱╱╱╱╱╱│     strips of either side that are narrower than a road go to the other
//     └────────────┴──────┘
//
// Patterns are anchored in the plane, so that rows of an area lie where they would if all of the
// inside were filled so. Areas change nothing where the inside is branches (lightning).
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings
#include "core/slices/slice.h"    // Slice

namespace core {

// A piece of the inside, and the settings that hold there.
struct InsidePiece {
  Region region;
  Settings settings;
};

// ENSURES: pieces don't overlap, and are `inside` together, to 2 units (boolean.h).
// COSTS: a few region operations and an offset for each area that meets the inside.
[[nodiscard]] std::vector<InsidePiece> inside_pieces(const Region& inside, const Slice& slice,
                                                     const Settings& settings);

// As loose_roads(), of each piece.
[[nodiscard]] std::vector<Road> inside_fill(const Region& inside, const Region& within,
                                            const Slice& slice, const Settings& settings);

}  // namespace core
