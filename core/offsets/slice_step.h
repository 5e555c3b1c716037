// How far contours move from one slice to the next: an upper bound, by one walk along both.
//
//     below ──●────────●──────▶   Two walkers go once round a ring and the ring it became, forwards
//             ┆ leash  ┆          only. Between two steps both move along straight lines, so the
//     above ──●───────●───────▶   leash is longest at a step.
//
// Let the longest leash be e. Then the two slices agree on every point that is farther than e from
// the contours of one of them. Proof: slide every point of a contour along its leash. All that is
// passed is within e of the contour, so the winding number of other points stays.
//
// Where the leash is long, it is asked whether one slice lies within the other. If so, nothing of
// what the larger one has is missing in the smaller one but within e of its contours, and in the
// other direction nothing is missing at all.
//
// The leash bounds the Fréchet distance (Alt and Godau 1995). The walk is greedy, so it may be
// longer than needed.
#pragma once

#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

// I_d(S): what of S is at least d away from its contours.
struct SliceStep {
  // Longer than any: nothing is known.
  static constexpr Length kUnknown = Length::from_units(std::int64_t{1} << 40);

  Length inwards = kUnknown;   // I_d(below) lies within above for every d > inwards
  Length outwards = kUnknown;  // I_d(above) lies within below for every d > outwards

  [[nodiscard]] Length longest() const { return inwards > outwards ? inwards : outwards; }
};

// Nothing is known where numbers of rings differ, or a leash gets longer than `most`. Up to `small`
// it does not matter which way contours move.
// COSTS: O(points); where contours move more than `small`, also as surely_clean().
[[nodiscard]] SliceStep slice_step(const Region& below, const Region& above, Length small,
                                   Length most);

}  // namespace core
