// What a layer's closed perimeters offer as a place to start at, found for each layer by itself.
//
// A corner hides a seam. Its merit is
//
//     hollow (the part's material is outside of it)    0.7 … 1    growing with how far the contour
//     jutting out                                      0 … 0.3    turns there (ring_corners.h)
//     none                                             0
//
// in the mean over this layer and those above it (SplitLayer::corners_above): a corner is followed
// from layer to layer, to the nearest one within kSeamFollow; where it is lost, it is worth nothing
// from there on. So one layer's corners alone, the first one's say, do not decide.
//
// A place is held where the slice below lies under the road's centre line.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/geometry.h"              // Box
#include "core/regions/ring_corners.h"  // RingPlace
#include "core/roads/layer_roads.h"     // LayerRoads
#include "core/roads/road.h"            // Road
#include "core/settings.h"              // Settings
#include "core/units.h"                 // Length
#include "core/walls/split_layer.h"     // SplitLayer

namespace core {

// How far a corner may move from one layer to the next.
inline constexpr Length kSeamFollow = Length::from_units(10'000);

struct SeamPlace {
  RingPlace place;
  double merit = 0;
};

// An outer perimeter.
struct SeamLoop {
  std::size_t island = 0;  // LayerRoads::islands[island][road]
  std::size_t road = 0;
  bool hole = false;  // around one; otherwise around an island
  Box box;
  double length_mm = 0;
  // Held ones, at most kSeamCornersMax: the best, in their order.
  std::vector<SeamPlace> corners{};

  // What is held, by point of the road and by the edge after it; an edge, when all of it is. Where
  // no point is held, places between them that are. All empty: it is all alike.
  std::vector<bool> held_points{};
  std::vector<bool> held_edges{};
  std::vector<RingPlace> held_between{};
};

// An inner perimeter, and the outer one that it is near to.
struct SeamFollower {
  std::size_t island = 0;
  std::size_t road = 0;
  std::size_t loop = 0;  // of LayerSeams::loops
};

struct LayerSeams {
  std::vector<SeamLoop> loops;
  std::vector<SeamFollower> followers;
};

// COSTS: O(points), and some O(log corners) for each corner and layer above.
[[nodiscard]] LayerSeams seam_loops(const SplitLayer& layer, const LayerRoads& roads);

[[nodiscard]] double seam_merit(double turn);

// Whether a seam may be at the place.
// REQUIRES: `road` is the loop's.
[[nodiscard]] bool is_held(const SeamLoop& loop, const Road& road, RingPlace place);

}  // namespace core
