// From where a branch of a tree can still reach the bed: one pass over the slices from the bed up.
//
//     slice n      ░░░░            avoided(n) = blocked(n) ∪ inset(avoided(n−1), step)
//     slice n−1    ░░░░░░░░░       blocked(n):  nearer to the slice than support_xy_distance and
//                  ┆  ╱╱╱╱ ┆                    the radius of a tip; and what is not over the bed
//     avoided:  the slice and its shadow, as steep as a branch may be
//
// A branch whose centre is outside avoided(n) has a place within one step that is outside
// avoided(n−1): the pass from the top down needs no other knowledge of what is below it.
//
// Regions, not cells: a distance for each cell of 0.5 mm places the part to half a cell only, and
// the bed's whole area costs in every layer; contours cost where there are some. Every error is on
// the safe side, and the growth of what is free is less than 1 % of a step short: arcs become
// chords on the free side, and what is simplified is inset by as much less. core/README.md has what
// 10,000 layers of 0.05 mm add up to.
//
// SOURCE: avoidance areas, as tree supports in Cura have them for some radii; here for the core of
// a branch only, which is why a branch may be thinner where there is no room (tree_fold.h).
#pragma once

#include "core/regions/region.h"         // Region
#include "core/settings.h"               // Settings
#include "core/supports/support_fold.h"  // SharedRegion
#include "core/units.h"                  // Length

namespace core {

// How far a branch moves sideways at most between two layers whose planes are so far apart.
[[nodiscard]] Length branch_step(Length planes, const Settings& settings);

// Of a branch's core, which nothing of the part comes near.
[[nodiscard]] Length branch_core(const Settings& settings);

// Where no centre of a branch may be in a layer, whatever is below it.
// COSTS: an offset of the slice.
[[nodiscard]] Region blocked_for_branches(const Region& slice, const Settings& settings);

class TreeReach {
 public:
  // REQUIRES: settings in their ranges.
  explicit TreeReach(const Settings& settings) : settings_(settings) {}

  // The next layer up, from 0; returns what is avoided in it. The same object where nothing has
  // changed. COSTS: two offsets and two booleans, none where nothing has changed.
  [[nodiscard]] SharedRegion push(const Region& slice, Length height);

 private:
  [[nodiscard]] SharedRegion avoided(Length height, bool same) const;

  Settings settings_;
  Region slice_;  // the last one
  Length height_;
  SharedRegion blocked_, avoided_;
};

}  // namespace core
