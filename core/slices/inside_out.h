// Turns contours that are inside out. Which of them bound bodies, and which bound holes?
//
// A clockwise contour is a hole if it lies within what the other contours enclose. If it reaches
// beyond that, it is a body whose mesh is inside out. Then it is turned, with its own holes, so
// that what it shares with other bodies is not cut out of them.
//
//     ┌──────┐                               ┌──────┐
//     │   ┌──┼──┐ clockwise: 1 and −1        │      └──┐
//     │   │  │  │ cancel where both are  ──> │         │
//     └───┼──┘  │                            └───┐     │
//         └─────┘                                └─────┘
//
// Where facets are known to be turned over against their neighbours (`unsure`), a counter-clockwise
// contour within another one may be the wall of a hole. There, a contour within a body is taken for
// a hole.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"  // Ring, Box, Point

namespace core {

// Points that are looked at along one contour.
inline constexpr int kTurnSamples = 64;
// Of them, so many must stand out: fewer are noise where contours touch.
inline constexpr int kTurnSamplesOut = 2;
// Edges that are looked at for one slice; beyond it, contours stay as they are.
inline constexpr std::int64_t kTurnWorkMax = 50'000'000;

struct TurnedRings {
  // Turned; 1 where something is inside out and it can't be said which ring: holes that cross.
  std::int64_t count = 0;
  std::optional<Point> first;  // a corner of the first one
};

// `unsure`: contours whose box meets this one; an empty box: all of them. Nothing: none.
// COSTS: a boolean operation; kTurnSamples times the edges for each ring that runs clockwise, or
// lies in `unsure`, but only where something broader than a sliver is inside out, or `unsure` is
// given.
[[nodiscard]] TurnedRings turn_inside_out(std::vector<Ring>& rings,
                                          const std::optional<Box>& unsure);

// Whether other rings do not enclose what this one encloses. For a ring that was there once in
// either direction and is not in `rings`. COSTS: as above.
[[nodiscard]] bool stands_out(const Ring& ring, const std::vector<Ring>& rings);

}  // namespace core
