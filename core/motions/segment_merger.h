// Fits roads to a slow serial line: no more pieces in a second than the line carries.
//
//     1  Straight pieces that would be laid faster than a line of G-code is sent are merged, as
//        long as all their points stay within the tolerance of the longer piece.
//
//            o──o─o──o──o──o    ──>   o────────────o
//
//     2  Where the next kSegmentWindow pieces are still too many for their time, the whole road is
//        laid slower. Otherwise the planner would run dry, stop at every piece, and leave a blob
//        there. The whole road, because each change of speed makes a line of G-code longer.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry.h"         // Point
#include "core/motions/arc_fit.h"  // RoadPiece

namespace core {

// Pieces whose mean time counts: what a planner holds.
inline constexpr std::size_t kSegmentWindow = 16;

// An arc's line is as long as two others.
inline constexpr std::size_t kArcLines = 2;

// Merges straight pieces shorter than length_min_mm into ones of about that length.
// REQUIRES: the pieces start at `from`; length_min_mm and tolerance_mm >= 0.
// ENSURES: points left out are within the tolerance of the pieces that stand for them, laid_over_mm
// sums up as before, arcs stay. COSTS: O(n k), k pieces merged into one.
void merge_short_pieces(Point from, std::vector<RoadPiece>& pieces, double length_min_mm,
                        double tolerance_mm);

// The fastest speed, at most `speed_mm_s`, at which kSegmentWindow pieces in a row take as many
// times time_min_s in the mean. REQUIRES: both > 0. COSTS: O(n).
[[nodiscard]] double sendable_speed(const std::vector<RoadPiece>& pieces, double speed_mm_s,
                                    double time_min_s);

}  // namespace core
