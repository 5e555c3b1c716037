// Point location: is this point in the region? For many questions about one region.
#pragma once

#include "core/geometry.h"             // Box, Point
#include "core/regions/edge_strips.h"  // EdgeStrips
#include "core/regions/region.h"       // Region

namespace core {

class PointLocation {
 public:
  // COSTS: as EdgeStrips.
  explicit PointLocation(const Region& region)
      : edges_(edges_of(region.rings())), box_(region.box()) {}

  // As Region::contains(), but for points on the boundary either answer is given.
  // COSTS: O(edges in the point's strip).
  [[nodiscard]] bool contains(Point point) const;

 private:
  EdgeStrips edges_;
  Box box_;
};

}  // namespace core
