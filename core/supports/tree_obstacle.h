// Where no centre of a branch may be, for many questions about one layer.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry.h"                // Point, Segment
#include "core/regions/point_location.h"  // PointLocation
#include "core/regions/region.h"          // Region
#include "core/regions/segment_grid.h"    // SegmentGrid
#include "core/units.h"                   // Length

namespace core {

class TreeObstacle {
 public:
  // COSTS: O(points).
  explicit TreeObstacle(const Region& region)
      : edges_(edges_of(region.rings())), inside_(region), grid_(kCell, edges_) {}

  [[nodiscard]] bool blocks(Point point) const { return inside_.contains(point); }
  // True when the straight way meets the obstacle's contour.
  [[nodiscard]] bool between(Point a, Point b) const { return grid_.crosses({a, b}); }

  // The point itself, or a free one that is nearest to it, or nearly; on the contour where no other
  // is found. nullopt: none is within.
  [[nodiscard]] std::optional<Point> nearest_free(Point point, Length within) const;

  // The nearest point of the contour. nullopt: none is within.
  [[nodiscard]] std::optional<Point> nearest_edge(Point point, Length within) const;

 private:
  static constexpr Length kCell = Length::from_units(20'000);

  std::vector<Segment> edges_;
  PointLocation inside_;
  SegmentGrid grid_;
};

}  // namespace core
