// Perimeters (also called walls or shells): roads along the contour, as far as the part is wide
// enough for them.
//
// A centre line is the slice's offset at the perimeter's depth, its core the offset a little
// deeper. Where the part narrows, the core ends before the two sides of the centre line come too
// near:
//
//     ──────────────────╮                 line: kept where the core is near,
//     ┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄ ╰──────────────   cut open where it is not
//       ╭─ core ─────╮      too narrow
//     ┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄┄ ╭──────────────   gap:  what no perimeter covers there, left for one
//     ──────────────────╯                       road of its own width (gap_fill.h)
//
// "Near" is twice the core's depth below the line, so that corners down to 60° stay whole.
#pragma once

#include <vector>

#include "core/offsets/layer_offsets.h"  // SliceOffsets
#include "core/regions/region.h"         // Region
#include "core/roads/road.h"             // Road
#include "core/settings.h"               // Settings
#include "core/slices/slice.h"           // Slice

namespace core {

// The parts of a centre line within `reach` of its core: closed roads where all of it is, open
// ones elsewhere. Pieces shorter than the road is wide stay as their neighbours are. Points that
// they don't need for `tolerance` are left out.
// COSTS: O(points).
[[nodiscard]] std::vector<Road> roads_near_core(const Region& line, const Region& core,
                                                Length reach, Length width, RoadKind kind,
                                                Length tolerance);

struct Perimeters {
  std::vector<Road> roads;
  Region gaps;  // of the slice without its interior: not covered by them
};

// COSTS: O(points), and a few booleans on a layer that has narrow places.
// REQUIRES: offsets made by an OffsetCutter with the same settings.
[[nodiscard]] Perimeters perimeters(const Slice& slice, const SliceOffsets& offsets,
                                    const Settings& settings);

}  // namespace core
