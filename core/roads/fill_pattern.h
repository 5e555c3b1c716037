// How a loose region is filled: lines over the plane, which are then clipped with the region and
// joined along its contours (loose_fill.h). A variant is a file.
#pragma once

#include <vector>

#include "core/geometry.h"  // Box, Point
#include "core/units.h"     // LayerIndex, Length

namespace core {

struct PatternPlace {
  Box box;              // of what is filled
  double distance = 0;  // units: a layer has a unit of length for each `distance` square units
  double width = 0;     // units: of a road
  double angle_degrees = 0;
  LayerIndex layer = 0;
  Length middle;  // height of the layer's middle over the bed
};

using PatternLines = std::vector<std::vector<Point>>;

class FillPattern {
 public:
  FillPattern() = default;
  FillPattern(const FillPattern&) = delete;
  FillPattern& operator=(const FillPattern&) = delete;
  virtual ~FillPattern() = default;

  // Open lines that begin and end outside the box, neighbours after one another. They are fixed to
  // the plane, not to the box: what two boxes share has the same lines.
  // REQUIRES: a box that is not empty, distance > 0.
  [[nodiscard]] virtual PatternLines lines(const PatternPlace& place) const = 0;
};

}  // namespace core
