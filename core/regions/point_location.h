// Point location: is this point in the region? For many questions about one region.
//
// Edges are entered in horizontal strips. A question looks at the edges of one strip only.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry.h"        // Point, Segment
#include "core/regions/region.h"  // Region

namespace core {

class PointLocation {
 public:
  // COSTS: O(edges + entries): an edge has an entry in every strip that it passes. There are at
  // most as many strips as edges, and at most kEntriesPerEdge entries an edge in the mean.
  explicit PointLocation(const Region& region);

  // As Region::contains(), but for points on the boundary either answer is given.
  // COSTS: O(edges in the point's strip).
  [[nodiscard]] bool contains(Point point) const;

 private:
  static constexpr std::int64_t kEntriesPerEdge = 8;

  [[nodiscard]] std::int64_t strip(std::int64_t y) const { return (y - bottom_) / height_; }

  std::vector<Segment> edges_;  // upwards or downwards, none level
  Box box_;
  std::int64_t bottom_ = 0;
  std::int64_t height_ = 1;
  std::vector<std::uint32_t> starts_;   // by strip, into entries_
  std::vector<std::uint32_t> entries_;  // edges
};

}  // namespace core
