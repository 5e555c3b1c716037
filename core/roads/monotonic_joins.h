// Monotonic rows: strung together so that no row is laid between two rows that are laid already.
// Then all of a surface has its rows against one side, and shines alike.
//
//     ═══════════════     A row is laid when all rows that it touches in the row below are. The way
//     ════ ╭──╮ ═════     goes on with a row above that one, joined along the contour where their
//     ════ ╰──╯ ═════     ends are neighbours there; else with the nearest of those that may be
//     ═══════════════     laid.
#pragma once

#include <vector>

#include "core/roads/boundary_joins.h"  // JoinedLines
#include "core/roads/line_clip.h"       // ClippedLine, LineClipper
#include "core/roads/row_rests.h"       // RowStretch
#include "core/units.h"                 // Length

namespace core {

// The ways in the order in which they have to be laid, each from its begin to its end.
// `stretches`: of the lines, in the order of rows, and along each row.
// COSTS: O(points + ends · log + rows · rows that may be laid at a time), and the
// stretches of every two neighbouring rows multiplied.
[[nodiscard]] JoinedLines join_monotonic(const std::vector<ClippedLine>& lines,
                                         const std::vector<RowStretch>& stretches,
                                         const LineClipper& clipper, Length longest);

}  // namespace core
