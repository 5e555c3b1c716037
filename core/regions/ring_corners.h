// Corners of a closed line as an eye sees them: how far it turns within a stretch of a given
// length, whatever points it is made of.
//
//             ●────── one arm ──────▸       the turn at ●: the angle between the chord from one arm
//            ╱ ) turn                       before it and the chord to one arm after it
//           ╱
//      one arm
//
// So a corner rounded by a small arc is one corner, and a circle of fine segments has none.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry.h"  // Point, Ring
#include "core/units.h"     // Length

namespace core {

// A place on a ring: on the edge from point `edge` to the next.
struct RingPlace {
  Point at;
  std::size_t edge = 0;
  bool operator==(const RingPlace&) const = default;
};

struct RingCorner {
  RingPlace place;  // a point of the ring
  double turn = 0;  // radians, −π … π; to the left is positive
};

// The ring's points where it turns by kCornerTurnMin or more, more than at any other point within
// one arm, and clearly more than one arm away. An arm is never longer than a quarter of the ring.
// COSTS: O(points + corners · points within an arm). REQUIRES: 3 points or more, arm > 0.
[[nodiscard]] std::vector<RingCorner> ring_corners(const Ring& ring, Length arm);

inline constexpr double kCornerTurnMin = 0.4;  // 23°

// Of corners in which a seam hides: about what the blob of a bead's end covers.
inline constexpr Length kCornerArm = Length::from_units(7'000);

// The nearest place on the ring; of equally near ones the first. A point that is within a unit of
// the ring is its own nearest place. COSTS: O(points). REQUIRES: two points or more.
[[nodiscard]] RingPlace nearest_place(const Ring& ring, Point to);

}  // namespace core
