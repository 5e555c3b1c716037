// Finds segments near a point, by a uniform grid. Is anything within reach of this point? Does this
// straight line cross a contour? What is in this box?
//
// Each segment is entered in every cell that its own line passes. A query looks only at the cells
// that it reaches. Cells lie row by row in one array; their number is bounded by the segments'.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry.h"        // Box, Point, Segment
#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

class SegmentGrid {
 public:
  // REQUIRES: cell > 0; about the reach of later queries or the segments' length. Cells are larger
  // where there would be more than kCellsPerSegment for each.
  // COSTS: O(segments + entries); a segment has an entry for every cell it passes.
  SegmentGrid(Length cell, std::vector<Segment> segments);
  SegmentGrid(Length cell, const Region& region);

  // True when a segment lies within `reach` of the point.
  [[nodiscard]] bool any_within(Point point, Length reach) const;

  // Adds the numbers of all segments that come into the box, and of some near it, each once, in
  // ascending order.
  void collect(const Box& box, std::vector<std::uint32_t>& numbers) const;

  // The same for all segments that the line crosses or touches.
  void collect_along(const Segment& line, std::vector<std::uint32_t>& numbers) const;

  // True when the line crosses or touches a segment.
  [[nodiscard]] bool crosses(const Segment& line) const;

 private:
  static constexpr std::int64_t kCellsPerSegment = 4;

  void choose_cells();
  void enter_segments();
  [[nodiscard]] std::int64_t column(double x) const;
  [[nodiscard]] std::int64_t row(double y) const;
  template <typename Visit>  // bool(cell): stop when true
  bool walk(const Segment& line, const Visit& visit) const;

  std::vector<Segment> segments_;
  std::int64_t cell_;
  double cells_per_unit_ = 0;
  Point origin_;
  std::int64_t columns_ = 0;
  std::int64_t rows_ = 0;
  std::vector<std::uint32_t> starts_;   // by cell, into entries_
  std::vector<std::uint32_t> entries_;  // segments
};

}  // namespace core
