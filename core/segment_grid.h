// Finds segments near a place, by a uniform grid: is anything within reach of this point, does
// this straight line cross a contour?
//
// Each segment is entered in every cell that its own line passes; a query looks only at the cells
// it reaches. Rows of the grid are hashed, so that far-apart segments cost no memory.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/geometry.h"  // Point, Segment
#include "core/region.h"    // Region
#include "core/units.h"     // Length

namespace core {

class SegmentGrid {
 public:
  // REQUIRES: cell > 0; about the reach of later queries or the segments' length.
  explicit SegmentGrid(Length cell) : cell_(cell.units()) {}

  void add(const Segment& segment);
  void add(const Region& region);

  // True when a segment lies within `reach` of the point.
  [[nodiscard]] bool any_within(Point point, Length reach) const;

  // True when the line crosses or touches a segment.
  [[nodiscard]] bool crosses(const Segment& line) const;

 private:
  using Cell = std::uint64_t;
  [[nodiscard]] std::int64_t column(std::int64_t coordinate) const;
  [[nodiscard]] static Cell key(std::int64_t column, std::int64_t row);
  template <typename Visit>  // bool(Cell): stop when true
  bool walk(const Segment& line, const Visit& visit) const;

  std::int64_t cell_;
  std::vector<Segment> segments_;
  std::unordered_map<Cell, std::vector<std::uint32_t>> cells_;
};

// Distance of a point from a segment, in units.
[[nodiscard]] double distance_units(Point point, const Segment& segment);

}  // namespace core
