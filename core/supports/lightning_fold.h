// Lightning fill: branches that hold the roofs over an inside that is empty otherwise, found from
// the top down.
//
//     ▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓   roof      seen along one line of the plane. Under a roof the whole
//     ▓│══════════════════│▓             line is branch; one layer lower it opens in its middle,
//     ▓│══════╮    ╭══════│▓             as far as a road can bridge; from there on its ends draw
//     ▓│════╮        ╭════│▓             back to the wall by h · tan(overhang_angle) a layer.
//     ▓│══╮            ╭══│▓
//
// Lines stand at fixed places of the bed, in two directions, kBranchSpacing of bridge_max apart:
// any road over them is held at least so often. On each line,
//
//     free(n)   = loose(n) ∩ (grow(free(n+1), step) ∪ gap(n) ∪ shallow(n))
//     branch(n) = loose(n) − free(n)
//
// shallow(n): what begins to be loose here, all of it within a step of the wall, and is under no
// branch: that wall holds what is over it.
//
// gap(n): within a branch from wall to wall that is branch in the layer above, too. A branch that
// touches no wall keeps a length of kPillarLength and stands on the floor.
//
// Spans of lines are exact, but for the last bits of a double: nothing drifts, and no points add
// up, whatever the number of layers.
//
// SOURCE: ribs whose open ends are worn away layer by layer are from Tricard, Claux, Lefebvre,
// "Ribbed support vaults for 3D printing of hollowed objects" (2019). There, ribs are segments from
// each unheld point to the nearest held one, and are straightened; here they are fixed lines.
//
// Keywords: lightning infill, ribbed vault.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "core/regions/region.h"       // Region
#include "core/settings.h"             // Settings
#include "core/supports/line_spans.h"  // LineSpans
#include "core/supports/roof_fold.h"   // InsideLayer
#include "core/units.h"                // Length
#include "core/walls/branch.h"         // Branches

namespace core {

// The gap that a branch opens with, as a share of bridge_max.
inline constexpr double kBranchGap = 0.8;

inline constexpr Length kPillarLength = Length::from_units(10'000);

// Shorter branches are not laid: the roads over them reach out as far by themselves.
inline constexpr Length kBranchMin = Length::from_units(3'000);

class LightningFold {
 public:
  // REQUIRES: settings in their ranges.
  explicit LightningFold(const Settings& settings);

  // The next layer down, as RoofFold has decided it; the first one is the highest. Returns its
  // branches, line by line. COSTS: O(points + crossings of lines and contours · log). Holds the
  // spans of one layer.
  [[nodiscard]] Branches push(const InsideLayer& layer);

 private:
  struct Line {
    LineSpans loose, free, branches;
  };
  using Lines = std::map<std::int64_t, Line>;  // by number, from the bed's corner

  // `deep`: what of it is farther than a step from the wall.
  [[nodiscard]] Line next_line(LineSpansView loose, LineSpansView deep, const Line& above,
                               double step) const;
  [[nodiscard]] LineSpans pillars(LineSpansView loose, const Line& above, double step) const;
  [[nodiscard]] LineSpans gaps(LineSpansView loose, const Line& at, const Line& above,
                               double step) const;

  Settings settings_;
  double spacing_;
  std::optional<InsideLayer> above_;
  Region inner_;                // of the layer at hand, a step from its edge
  std::array<Lines, 2> lines_;  // of the layer above, by direction
};

}  // namespace core
