// All roads of a layer, island by island of its slice, not in order yet.
#pragma once

#include <vector>

#include "core/geometry.h"    // Point
#include "core/roads/road.h"  // Road

namespace core {

using IslandRoads = std::vector<Road>;

struct LayerRoads {
  Point from;                        // where the nozzle is taken to come from
  std::vector<Road> first;           // skirt: printed before all others, in this order
  std::vector<IslandRoads> islands;  // each in any order
  bool outer_first = false;          // outer perimeters before inner ones
};

}  // namespace core
