// How firmly a body stands on the bed: the nozzle pushes at its top, the bed holds its foot.
//
//     F ──▶ ┌─┐  ┬          It may come loose where the bed's pull at the foot's edge is more than
//           │ │  │ h        the bed holds:
//           │ │  │              F · h  >  σ · W,     W = A · b / 6
//        ───┴─┴─────        W: the section modulus of a rectangle of area A and breadth b. Of a
//           ├b┤             ring, or of several legs, that is less than they have.
//
// F and σ are those with which PrusaSlicer looks for objects that fall over (its source
// SupportSpotsGenerator.hpp, for PLA): 10 g and 0.02 MPa.
#pragma once

#include <optional>

#include "core/geometry.h"  // Point, Ring

namespace core {

inline constexpr double kNozzlePushNewtons = 0.0981;
inline constexpr double kBedHoldMpa = 0.02;

// A body that is lower than so many times its foot's breadth is not told: it doesn't swing, and
// beds usually hold better than PrusaSlicer's cautious figure.
inline constexpr double kSlendernessTold = 5;

// What is printed at all is a road broad or so, however narrow its slice.
inline constexpr double kRoadBreadth_mm = 0.4;

// No wider brim is advised: another way to hold the part is better then.
inline constexpr int kBrimAdvisedMax_mm = 20;

// What stands on the bed: one island of the first layer, or several that are joined above.
struct Foot {
  Point at;               // in the middle of its box
  double breadth_mm = 0;  // least breadth of the convex hull
  double area_mm2 = 0;    // that touches the bed
  double outline_mm = 0;  // of the hull
};

// `hull` as by convex_hull(). COSTS: O(points).
[[nodiscard]] Foot foot_of(const Ring& hull, double area_mm2);

// With a brim all around. REQUIRES: brim_mm ≥ 0.
[[nodiscard]] Foot with_brim(Foot foot, double brim_mm);

// Height by breadth; by kRoadBreadth_mm where that is more.
[[nodiscard]] double slenderness(const Foot& foot, double height_mm);

[[nodiscard]] bool may_come_loose(const Foot& foot, double height_mm);

// The narrowest brim, in whole millimetres, with which it need not be told; nullopt: none up to
// kBrimAdvisedMax_mm.
[[nodiscard]] std::optional<int> brim_that_holds_mm(const Foot& foot, double height_mm);

}  // namespace core
