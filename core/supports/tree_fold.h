// Tree supports: the dense layers under what hangs as in support_fold.h, one more layer of rows
// under them, and branches that hold these, from the top down.
//
//     ░░░░░░░░░░░░░░░░  part
//     ▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓  roof: dense layers under what hangs,
//     ├───┼───┼───┼───  and one of rows across theirs
//      o   o   o   o    tips under the rows, support_tip_spacing apart, and along the roof's edge
//       ╲ ╱     ╲ ╱
//        O       O      branches (tree_nodes.h), which grow wider downwards
//         ╲     ╱
//     ░░░  ╲   ╱        around the part (tree_reach.h), to the bed; where there is no way there,
//     ░░░   ( )         straight down on the part
//
// The core of a branch, as wide as a tip, has room all the way; what is around it is left out where
// there is none: nearer to the part than support_xy_distance, or where it would stand on nothing.
// What then still stands on nothing is left out by tree_standing.h.
//
// With supports = bed, what has no branch within its reach gets no roof.
//
// Memory: the nodes of one layer, and the slices that support_fold.h holds.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/regions/region.h"          // Region
#include "core/settings.h"                // Settings
#include "core/supports/support_fold.h"   // FoldSlice, SharedRegion, SupportFold, SupportLayer
#include "core/supports/tree_nodes.h"     // TreeNodes
#include "core/supports/tree_obstacle.h"  // TreeObstacle
#include "core/units.h"                   // LayerIndex, Length

namespace core {

class TreeFold {
 public:
  // REQUIRES: settings in their ranges, of trees.
  explicit TreeFold(const Settings& settings);

  // The next slice down, and what TreeReach found for its layer. As SupportFold, with
  // COSTS: besides, some booleans of the layer's branches, and O(nodes · neighbours).
  void push(FoldSlice slice, SharedRegion avoided);
  void end() { roofs_.end(); }
  [[nodiscard]] std::optional<SupportLayer> next();

  // Of the layer that next() gave last. For tests.
  [[nodiscard]] const std::vector<TreeNode>& nodes() const { return nodes_.all(); }

 private:
  struct Level {
    FoldSlice slice;
    SharedRegion avoided;
  };

  [[nodiscard]] const Level* level(LayerIndex index) const;
  [[nodiscard]] SupportLayer decide(const Level& at, SupportLayer roof);
  [[nodiscard]] Length tip_reach() const;
  void look(const Level& at);
  void start_tips(const Region& open, Length height);
  [[nodiscard]] Region branches(const Level& at, bool to_bed) const;
  [[nodiscard]] Region laid_to_bed(const Level& at) const;
  [[nodiscard]] Region with_cores(const Region& laid) const;
  [[nodiscard]] Region laid_on_part(const Level& at);
  [[nodiscard]] Region slices_between(LayerIndex from, LayerIndex to) const;
  [[nodiscard]] Region within_reach(const Level& at, const Region& roof) const;

  Settings settings_;
  SupportFold roofs_;
  std::deque<Level> levels_;  // from the top down
  TreeNodes nodes_;
  const Region beyond_bed_;  // near its edge
  SharedRegion roof_above_;
  // Of the layer that is being decided: they last for some layers.
  SharedRegion avoided_of_, blocked_of_;
  std::unique_ptr<const TreeObstacle> avoided_, blocked_;
  Region cut_;  // what is left out of branches to the bed
};

}  // namespace core
