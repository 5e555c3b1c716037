// Rectilinear infill: parallel straight roads, turned by 90° from layer to layer. Neighbours are
// joined at their ends (zigzag).
//
//     ╱╲  ╱╱╲          rows of one grid, turned by the fill angle, at the area's distance;
//    ╱╱ ╲╱╱  ╲         a row's stretches `inset` deep inside `region` become roads; the next
//    ╲╱  ╲╲  ╱         row's nearest end is joined to a road's end where the join is short and
//     ╲╱  ╲╲╱          stays inside the region
//
// The grid is fixed to the plane, not to the area: rows of one layer lie over those of the layer
// two below.
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road, RoadKind
#include "core/units.h"           // LayerIndex, Length

namespace core {

// What is to be filled, and with what.
struct FillArea {
  const Region& region;  // to be filled
  LayerIndex layer = 0;
  RoadKind kind = RoadKind::kSolid;
  Length width;     // of the roads
  Length distance;  // of neighbouring centre lines
  Length inset;     // how deep inside the region centre lines start
};

class LineFill {
 public:
  // The angle of even layers' rows against the x axis.
  explicit LineFill(double angle_degrees) : angle_degrees_(angle_degrees) {}

  // ENSURES: every road has two points or more and stays inside the region.
  // COSTS: O(points + crossings of rows and edges · log).
  // REQUIRES: area.distance > 0.
  [[nodiscard]] std::vector<Road> fill(const FillArea& area) const;

 private:
  double angle_degrees_;
};

}  // namespace core
