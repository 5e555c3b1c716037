// Turns contours that are inside out, as a person would: which of them bound bodies, which bound
// holes?
//
// A contour that runs clockwise is a hole where it lies within what others enclose. One that stands
// out of it is a body whose mesh is inside out: it is turned, and its own holes with it, so that
// what it shares with other bodies is not cut out of them.
//
//     ┌──────┐                               ┌──────┐
//     │   ┌──┼──┐ clockwise: 1 and −1        │      └──┐
//     │   │  │  │ cancel where both are  ──> │         │
//     └───┼──┘  │                            └───┐     │
//         └─────┘                                └─────┘
//
// Where facets are known to be turned over against their neighbours (`unsure`), a contour that runs
// counter-clockwise within another may be the wall of a hole. There, what lies within a body is
// taken for a hole.
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

// Of a ring that was there once in either direction, and stands in `rings` in neither: what it
// encloses is not enclosed by others. COSTS: as above.
[[nodiscard]] bool stands_out(const Ring& ring, const std::vector<Ring>& rings);

}  // namespace core
