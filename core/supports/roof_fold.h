// An inside that holds up its own roof: one pass over the insides from the top down, which makes
// solid what nothing else would hold.
//
//     layer n+1    ▓▓▓▓▓▓░░░░░░░░▓▓▓▓▓▓     what is loose grows downwards by h · tan(angle),
//     layer n      ▓▓▓▓░░░░░░░░░░░░▓▓▓▓     no more, so that solid lies on solid
//     layer n−1    ▓▓░░░░░░░░░░░░░░░░▓▓
//
//     loose'(n) = loose(n) ∩ (grow(loose'(n+1), h · tan(angle)) ∪ seed(n)) − kept(n)
//
// seed(n): where a roof begins (loose here, nothing loose above) and rows can bridge it, held at
// both ends and no longer than bridge_max. A wider roof is cut into strips by thin walls. A roof
// that gets wider below, and can still be bridged there, is begun as low as possible: a dome's.
// Without a seed the inside becomes solid, because grow(∅) = ∅.
//
// kept(n): what is solid above and too thin to shrink any further. It stands on the floor, where a
// formula without it would leave the lowest edge between two hollows hanging in the air.
//
// Loose becomes solid, never the other way.
//
// For a lightning fill (lightning_fold.h) the inside grows faster, by kRowReachWidths: a row of the
// roof that reaches out so far and comes back is held. Branches do the rest: wide roofs are not cut
// into strips, and of thin walls only those are kept that no branch passes under.
//
// Growth is at most kGrowthLoss of the step short of exact, and never more than exact; what is
// carried down is simplified, so that points don't add up. Where all that is new is narrower than a
// step and than half a road, it becomes loose as it is, corners and tips too: its sides hold it.
//
// SOURCE: the cone of self-supporting hollows is the one of Hornus et al., "Tight printable
// enclosures and support structures" (2016), here with bridged roofs.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "core/geometry.h"        // Box
#include "core/regions/region.h"  // Region
#include "core/settings.h"        // Settings
#include "core/units.h"           // LayerIndex, Length

namespace core {

// What growth may lack, as a share of the step; and what rounding to the grid takes, 4 units.
inline constexpr double kGrowthLoss = 0.01;

// Most that a step is, in road widths, whatever the angle: a row along the edge of what is solid
// keeps half of its width on the layer below.
inline constexpr double kStepWidthsMax = 0.4;

// The step with a lightning fill, in road widths.
inline constexpr double kRowReachWidths = 0.9;

// Distance of the lines of a lightning fill, as a share of bridge_max. Roads at 45° to both
// directions are held every √2 times as far.
inline constexpr double kBranchSpacing = 0.65;

// Solid pieces between hollows, smaller than this, are kept down to the floor.
inline constexpr double kPillarArea_mm2 = 4;

// The walls between strips of a wide roof, in road widths.
inline constexpr double kRibWidths = 1;

struct InsideLayer {
  LayerIndex index = 0;
  Length bottom;
  Length height;
  std::shared_ptr<const Region> loose;  // not null
  // Of what the fold gives: where a roof is bridged, and what was loose before; not null.
  std::shared_ptr<const Region> seed{}, given{};
};

// How far what is solid may reach out over what is loose: h · tan(overhang_angle), h: the distance
// of the two layers' middles; at most kStepWidthsMax.
[[nodiscard]] Length cone_step(const InsideLayer& above, const InsideLayer& below,
                               const Settings& settings);

// Distance of the lines of a lightning fill's branches.
[[nodiscard]] Length branch_spacing(const Settings& settings);

// The same with what the settings ask for: with a lightning fill, kRowReachWidths.
[[nodiscard]] Length roof_step(const InsideLayer& above, const InsideLayer& below,
                               const Settings& settings);

class RoofFold {
 public:
  // REQUIRES: settings in their ranges.
  explicit RoofFold(const Settings& settings);

  // The next inside down, as the window has it; the first one is the highest layer's. After each,
  // take what next() has.
  // COSTS: where nothing changes, a comparison; else up to eight offsets and as many booleans, and
  // for each roof that begins O(points + rows) for some directions. Holds three layers.
  void push(InsideLayer layer);

  // No layer follows: the first one was the last.
  void end() { ended_ = true; }

  // The layers that are decided, from the top down, each once.
  // ENSURES: loose' ⊆ loose, to 2 units (boolean.h).
  [[nodiscard]] std::optional<InsideLayer> next();

 private:
  using SharedRegion = std::shared_ptr<const Region>;
  struct Level {
    InsideLayer given;   // regular
    SharedRegion loose;  // what stays loose
    SharedRegion waits;  // roof that is begun lower down
  };
  struct Seeds {
    std::vector<Ring> begun, waiting;
  };

  [[nodiscard]] SharedRegion regular(const SharedRegion& loose);
  [[nodiscard]] SharedRegion decide(Level& at, const Level& above, const InsideLayer* below);
  [[nodiscard]] Seeds seeds(const Level& at, const Level& above, const InsideLayer* below,
                            const Region& grown) const;
  void place(const Region& roof, const Region& around, const InsideLayer& at,
             const InsideLayer* below, Seeds& seeds) const;
  [[nodiscard]] bool can_be_bridged(const Region& roof, const Region& around) const;
  [[nodiscard]] Region kept(const Region& loose, const Region& grown, const Region& solid,
                            Length step) const;
  // Whether a line of branches passes through it.
  [[nodiscard]] bool held_by_branches(const Box& box) const;
  [[nodiscard]] Region cut_into_strips(const Region& roof) const;

  Settings settings_;
  SharedRegion none_;
  Length rib_;
  std::deque<Level> levels_;  // from the top down: decided ones, and the one to be decided
  bool ended_ = false;
  SharedRegion irregular_, regular_;  // the latest
};

}  // namespace core
