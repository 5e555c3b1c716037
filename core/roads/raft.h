// The raft: layers under the part that hold it on the bed and are torn off later. It covers the
// part's first slice grown by raft_expansion, without holes smaller than kRaftHoleMin_mm2:
//
//     ═╪═╪═╪═╪═╪═   dense: the upper half of the layers, but not the first
//     │  │  │  │    sparse: the layers under them, half full
//     ══ ══ ══ ══   the first: raft_first_layer_density
//
// Each is one perimeter with rows in it, across those under them, and the part's first rows run
// across the raft's last ones. The skirt and the brim lie around the first one.
#pragma once

#include <vector>

#include "core/regions/region.h"     // Region
#include "core/roads/road.h"         // Road
#include "core/settings.h"           // Settings
#include "core/units.h"              // LayerIndex
#include "core/walls/split_layer.h"  // SplitLayer

namespace core {

// What sparse layers between the first and the dense ones hold.
inline constexpr double kRaftSparseDensity = 0.5;

// Rows that end at every small hole cost more travel than what the holes save.
inline constexpr double kRaftHoleMin_mm2 = 25;

// The share of the raft's layer that is filled. REQUIRES: 0 <= layer < raft_layers.
[[nodiscard]] double raft_density(const Settings& settings, LayerIndex layer);

struct RaftLayer {
  SplitLayer layer;         // dense layers are solid, sparse ones loose
  std::vector<Road> roads;  // in printing order; kRaft, but for skirt and brim
};

class Raft {
 public:
  // `first`: the part's first slice. COSTS: an offset. REQUIRES: settings in their ranges.
  Raft(const Region& first, const Settings& settings);

  // ENSURES: no bead leaves that region by more than 0.035 mm, but for skirt and brim; what is
  // laid is the layer's share of its volume. COSTS: as the perimeters and the fill of one layer.
  // REQUIRES: 0 <= layer < raft_layers.
  [[nodiscard]] RaftLayer layer(LayerIndex layer) const;

 private:
  [[nodiscard]] Settings settings_of(LayerIndex layer) const;

  Settings settings_;
  Region region_;  // of every layer
};

}  // namespace core
