// Solid infill: fills the wall without a void and without laying more than it holds.
//
//     wide parts     parallel roads at the fill angle, joined at their ends (line_fill.h)
//     bands          where at most four roads fit side by side: roads along the edges, because the
//                    joins of short rows would lay far too much (concentric infill)
//     gaps           what both leave: roads of fitting width (gap_fill.h); the innermost roads
//                    along the edges hold the rest
//
// Joins lay material where the rows that they connect have laid some already, and rows that end
// before the edge lay too little there. Let s be the volume-true distance, c the depth at which
// rows end, b the mean breadth of a piece and p the rows' distance. The two errors cancel when
//
//     p = s (1 + (p − 2c) / b)
//
// So a narrow piece gets rows a little farther apart, though never so far that beads don't touch. A
// wide one gets rows at nearly the volume-true distance, with c near s / 2: it is as full in the
// middle as at the edge. The roads' width makes up for the difference that is left: what is laid is
// what the piece holds. Where rows are so short that they would lay kRowsMost of it even then, they
// give way to roads along the edges, but not in tops and bottoms.
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings
#include "core/units.h"           // LayerIndex, Length

namespace core {

inline constexpr double kRowsMost = 1.06;

// `rim`: of a piece that gets rows, this is filled by itself, and the rows begin behind it, if
// there is room for them; empty: nothing.
// COSTS: some offsets of each piece, for a band a boolean with the outlines of its roads, and a
// medial axis of each gap.
[[nodiscard]] std::vector<Road> wall_roads(const Region& wall, const Region& rim, LayerIndex layer,
                                           Length height, const Settings& settings);

// The same for tops and bottoms (solid_areas.h), of that kind, with the width, the flow and the
// pattern of tops. ENSURES: roads of the monotonic pattern are in the order and the direction in
// which they have to be laid.
[[nodiscard]] std::vector<Road> surface_roads(const Region& surface, RoadKind kind,
                                              LayerIndex layer, Length height,
                                              const Settings& settings);

// Rows over a top, so near to one another and of so little flow that they smooth it.
[[nodiscard]] std::vector<Road> ironing_roads(const Region& top, LayerIndex layer, Length height,
                                              const Settings& settings);

}  // namespace core
