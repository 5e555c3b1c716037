// What of the branches stands, from layer 0 up: what lies within two steps of the piece below it,
// or of the part, where they come down on it.
//
//     layer n      ▓▓▓▓▓▓▓▓░░░      ░  a lobe that the layers below have no room for: it is left
//     layer n−1    ▓▓▓▓▓▓▓             out, and with it what would stand on it
//
// The pass from the top down can't know them. No core of a branch (tree_fold.h) is such a lobe.
#pragma once

#include "core/supports/support_fold.h"  // SharedRegion, SupportLayer
#include "core/units.h"                  // Length

namespace core {

class TreeStanding {
 public:
  // REQUIRES: layers in order, from 0. COSTS: a walk along the contours of branches; where these
  // don't follow those below, an offset and some booleans.
  [[nodiscard]] SupportLayer standing(const SupportLayer& layer);

 private:
  [[nodiscard]] SupportLayer trimmed(const SupportLayer& layer) const;

  SharedRegion below_;  // null: the bed
};

// How far a piece may lie beyond what it stands on.
[[nodiscard]] Length branch_overhang(Length step);

}  // namespace core
