// Strings lines together along the contours that they end at, so that the nozzle travels less.
//
//     ╭──╮  ╭──╮  ╭       Each end of a line is joined to one of its two neighbours along its ring,
//     │  │  │  │  │       or to none. So joins lead through no hole, and of two stretches beside
//     │  ╰──╯  ╰──╯       one end at most one is laid: about half of the contour.
//
// Lines are taken in their order; from either end of one, the way goes on to the nearer neighbour
// that belongs to no way yet. At last, ways whose ends are neighbours are joined, the nearest
// first, unless that closes a circle.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry.h"         // Point
#include "core/roads/line_clip.h"  // ClippedLine, LineClipper
#include "core/units.h"            // Length

namespace core {

inline constexpr std::size_t kNotJoined = static_cast<std::size_t>(-1);

struct JoinedLines {
  std::vector<std::vector<Point>> ways;
  // By end, 2 i where line i begins and 2 i + 1 where it ends: the end that it is joined to.
  std::vector<std::size_t> partners;
};

// The lines, as pieces of `clipper`'s region, joined where the way along the ring is at most
// `longest`. COSTS: O(points + ends · log).
[[nodiscard]] JoinedLines join_along_boundary(const std::vector<ClippedLine>& lines,
                                              const LineClipper& clipper, Length longest);

}  // namespace core
