// Fills an area with parallel straight roads, turned by 90° from layer to layer, neighbours joined
// at their ends.
//
//     ╱╲  ╱╱╲          rows of one grid, turned by the fill angle, at the area's distance;
//    ╱╱ ╲╱╱  ╲         a row's stretches `inset` deep inside `region` become roads, drawn
//    ╲╱  ╲╲  ╱         on by `anchor` inside `within`; the next row's nearest end is joined to a
//     ╲╱  ╲╲╱          road's end where the join is short and stays inside the region
//
// The grid is fixed to the plane, not to the area: rows of one layer lie over those of the next
// but one.
#pragma once

#include "core/roads/fill.h"  // FillArea, FillPattern

namespace core {

class LineFill : public FillPattern {
 public:
  enum class Joins { kNone, kNearEnds };

  // The angle of even layers' rows against the x axis.
  LineFill(double angle_degrees, Joins joins) : angle_degrees_(angle_degrees), joins_(joins) {}

  // COSTS: O(points + crossings of rows and edges · log).
  // REQUIRES: area.distance > 0.
  [[nodiscard]] std::vector<Road> fill(const FillArea& area) const override;

 private:
  double angle_degrees_;
  Joins joins_;
};

}  // namespace core
