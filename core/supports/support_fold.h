// Where supports stand: one pass over the slices from the top down, in memory that does not grow
// with the part's height.
//
//     slice n+1    ░░░░████████        what hangs of it (marked_hanging.h) is demand in layer n
//     slice n          ████████
//
//     demand(n) = (demand(n+1) ∪ hanging(n+1)) − slice(n)
//
// Demand is carried down and never widened, simplified or offset: on one grid, union and difference
// are idempotent, so that any number of equal layers leaves it as it is. What is laid in layer n
// follows from it anew in each layer:
//
//     ░░░░░░░░░░░░░  part          opened demand of layer n + top gap,
//                    top gap       less the slice, support_xy_distance around it; half of that
//     ▓▓▓▓▓▓▓▓▓▓▓▓▓  interface     right under what hangs, so that it is held to its edge,
//     │  │  │  │  │  support       less the slices of the gaps above and below;
//     ▓▓▓▓▓▓▓▓▓▓▓▓▓  interface     wider towards the bed (support_base_expansion)
//                    bottom gap
//     ░░░░░░░░░░░░░  part, or the bed
//
// What hangs so low that its gap would reach into the bed is held by the first layer, with what gap
// is left.
//
// Under an island the whole island is demand, at least support_section_min wide; no opening or
// least area applies to it. No least area applies to what people enforce.
//
// SOURCE: the downward projection is that of all slicers. What is new is that nothing of the part
// is held but the slices of the gaps and interfaces around one layer.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "core/regions/region.h"            // Region
#include "core/settings.h"                  // Settings
#include "core/slices/slice.h"              // SupportMarks
#include "core/supports/support_heights.h"  // SupportHeights
#include "core/units.h"                     // LayerIndex, Length

namespace core {

using SharedRegion = std::shared_ptr<const Region>;

// A slice as the fold needs it. Equal slices that follow one another may share their region: what
// follows from them is then not computed again.
struct FoldSlice {
  LayerIndex index = 0;
  Length bottom;
  Length height;
  SharedRegion region;                          // not null
  std::shared_ptr<const SupportMarks> marks{};  // null: none
};

struct SupportLayer {
  LayerIndex index = 0;
  SharedRegion region;     // all of it; not null
  SharedRegion interface;  // the part of it that is dense; not null
  // Of trees; null: nothing.
  SharedRegion branches = nullptr;  // the part of it that is hollow
  SharedRegion feet = nullptr;      // where branches come down on the part
  Length step = {};                 // how far branches have moved at most

  [[nodiscard]] bool empty() const { return region->empty(); }
};

class SupportFold {
 public:
  // With support_style = tree, what is laid is the dense layers under what hangs, and one more
  // layer under them that is not dense (tree_fold.h). REQUIRES: settings in their ranges.
  explicit SupportFold(const Settings& settings);

  // The next slice down; the first one is the part's highest. After each, take what next() has.
  // COSTS: marked_hanging(), two booleans; and for the layer that is decided some offsets and
  // booleans, none where nothing has changed. Holds the slices of the gaps and interfaces, at most
  // support_top_gap_layers + support_interface_layers above a layer, and
  // support_bottom_gap_layers + support_bottom_interface_layers below it.
  void push(FoldSlice slice);

  // Higher layers are not decided. REQUIRES: called before the first slice.
  void decide_from(LayerIndex index) { decide_from_ = index; }

  // No slice follows: layer 0 was the last.
  void end() { ended_ = true; }

  // The layers that are decided, from the top down, each once.
  [[nodiscard]] std::optional<SupportLayer> next();

  // Demand of the lowest layer so far, but for islands'. For tests.
  [[nodiscard]] const Region& demand() const { return *levels_.back().overhangs; }

 private:
  // A layer, and what hangs over it.
  struct Level {
    FoldSlice slice;
    SharedRegion born;       // hanging of the layer above, islands widened
    SharedRegion overhangs;  // demand
    SharedRegion islands;    // demand
    SharedRegion enforced;   // demand, of the overhangs'
  };
  // What a layer's support was made of, by identity: two layers of the same are alike.
  struct Made {
    std::vector<SharedRegion> of;
    Length base;
    SupportLayer layer;
  };

  // The latest of what is made from slices and demand alone: it lasts for some layers.
  struct GrownSlice {
    SharedRegion of;
    // By support_xy_distance, and by what is kept right under what hangs.
    Region far, near;
  };
  struct Held {
    SharedRegion overhangs, islands, enforced;
    Region region;
  };

  void drop_above();
  [[nodiscard]] const GrownSlice& grown_slice(const SharedRegion& slice);
  [[nodiscard]] LayerIndex top_gap_over(LayerIndex index) const;
  [[nodiscard]] const Level* level(LayerIndex index) const;
  [[nodiscard]] SupportLayer decide(const Level& at);
  [[nodiscard]] std::vector<SharedRegion> inputs_of(LayerIndex index) const;
  [[nodiscard]] const Region& held_by(const Level& source);
  [[nodiscard]] Region united(LayerIndex from, LayerIndex to, SharedRegion Level::*what) const;
  [[nodiscard]] Region slices_between(LayerIndex from, LayerIndex to) const;
  [[nodiscard]] Region laid(const Level& at, const Level& source, Length base);
  [[nodiscard]] Region interface_of(const Level& at, const Region& region) const;

  Settings settings_;
  SupportHeights heights_;
  SharedRegion none_;
  std::deque<Level> levels_;  // from the top down
  LayerIndex next_ = -1;      // to be decided
  std::optional<LayerIndex> decide_from_;
  bool ended_ = false;
  std::optional<Made> made_;
  GrownSlice grown_;
  Held held_;
};

}  // namespace core
