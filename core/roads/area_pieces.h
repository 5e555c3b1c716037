// Cuts polylines at the borders of areas that don't overlap.
//
//              ┌────────────┐
//     ━━━━━━━━━●━━━━━━━━━━━━●━━━━━━     three pieces
//              └────────────┘
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"                // Point, Segment
#include "core/regions/point_location.h"  // PointLocation
#include "core/regions/region.h"          // Region
#include "core/regions/segment_grid.h"    // SegmentGrid
#include "core/units.h"                   // Length

namespace core {

// Shorter pieces belong to what is before them, or, at a line's start, behind them.
inline constexpr Length kAreaPieceMin = Length::from_units(2'000);

struct AreaPiece {
  static constexpr int kNoArea = -1;

  int area = kNoArea;  // by number
  double length_mm = 0;
  std::vector<Point> points;  // the first is the last of the piece before
  // Where they lie on the line: 2.25 is a quarter of the way from its point 2 to its point 3.
  std::vector<double> places;
};

class AreaPieces {
 public:
  AreaPieces() = default;  // no area
  // COSTS: O(points).
  explicit AreaPieces(const std::vector<Region>& areas);

  [[nodiscard]] bool empty() const { return areas_.empty(); }

  // ENSURES: the pieces are the line, in their order; each lies within its area, but for
  // kAreaPieceMin. Nothing where the line has no length. COSTS: a look at a grid for each segment.
  [[nodiscard]] std::vector<AreaPiece> cut(const std::vector<Point>& line) const;

 private:
  [[nodiscard]] int area_at(Point point) const;
  [[nodiscard]] std::vector<double> crossings(const Segment& way) const;

  std::vector<PointLocation> areas_;
  std::vector<Segment> edges_;
  std::optional<SegmentGrid> grid_;  // of these
};

}  // namespace core
