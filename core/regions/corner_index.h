// The corners of a region's contours, to be found by where they are.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"        // Point
#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

class CornerIndex {
 public:
  struct Corner {
    Point at;
    double turn = 0;  // negative: the region is hollow there (ring_corners.h)
  };

  // Corners as ring_corners() finds them with that arm. COSTS: O(points), and sorting the corners.
  CornerIndex(const Region& region, Length arm);

  // The nearest corner within `reach` that turns to the same side as `turn`; of equally near ones
  // the first by row, then by x, then by y.
  // COSTS: O(log corners + corners in the rows within reach).
  [[nodiscard]] std::optional<Corner> nearest(Point to, double turn, Length reach) const;

 private:
  std::vector<Corner> corners_;  // by row of kRowUnits, then by x
};

}  // namespace core
