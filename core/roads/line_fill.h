// Rectilinear infill: parallel straight roads, turned by 90° from layer to layer. Neighbours are
// joined at their ends (zigzag).
//
//     ╱╲  ╱╱╲          rows of one grid, turned by the fill angle, at the area's distance;
//    ╱╱ ╲╱╱  ╲         clipped `inset` deep inside the region, and joined there along its edge
//    ╲╱  ╲╲  ╱         where the way is short (boundary_joins.h)
//     ╲╱  ╲╲╱
//
// The grid is fixed to the plane, not to the area: rows of one layer lie over those of the layer
// two below.
#pragma once

#include <vector>

#include "core/regions/region.h"   // Region
#include "core/roads/road.h"       // Road, RoadKind
#include "core/roads/row_rests.h"  // RowStretch
#include "core/units.h"            // LayerIndex, Length

namespace core {

// What is to be filled, and with what.
struct FillArea {
  const Region& region;  // to be filled
  LayerIndex layer = 0;
  RoadKind kind = RoadKind::kSolid;
  Length width;            // of the roads
  Length distance;         // of neighbouring centre lines
  Length inset;            // how deep inside the region centre lines run
  Length tolerance;        // of the inset's round corners
  bool monotonic = false;  // monotonic_joins.h; roads are then in the order to lay them in
  bool joined = true;      // rows at their ends, along the edge
};

struct FilledRows {
  std::vector<Road> roads;
  std::vector<RowStretch> stretches;  // the rows in them, in the order of rows
};

class LineFill {
 public:
  // The angle of even layers' rows against the x axis.
  explicit LineFill(double angle_degrees) : angle_degrees_(angle_degrees) {}

  [[nodiscard]] double angle_degrees(LayerIndex layer) const {
    return angle_degrees_ + (layer % 2 == 0 ? 0 : 90);
  }

  // ENSURES: every road has two points or more and stays `inset` deep inside the region.
  // COSTS: O(points + crossings of rows and edges · log), and an offset of the region.
  // REQUIRES: area.distance > 0.
  [[nodiscard]] FilledRows fill(const FillArea& area) const;

 private:
  double angle_degrees_;
};

}  // namespace core
