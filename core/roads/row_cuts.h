// Parallel rows of any direction, and where they cut a region.
//
//     across ↑   ────[═════]────[══]───   row 2      [═══] a span inside the region
//            │   ───[═══════════════]──   row 1
//            │   ────[═══════════]─────   row 0
//            └────────────────────────▶ along
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry.h"        // Point
#include "core/regions/region.h"  // Region
#include "core/vector.h"          // Vector

namespace core {

// A stretch of a row, in units along it.
struct RowSpan {
  double from = 0;
  double to = 0;

  [[nodiscard]] double length() const { return to - from; }
};

// Rows at across = first + i · distance, i = 0 … count − 1.
struct RowGrid {
  Vector direction{1, 0};  // of the rows; of length 1
  double first = 0;
  double distance = 1;
  std::size_t count = 0;

  // x: along the rows, y: across.
  [[nodiscard]] Vector to_rows(Point point) const;
  [[nodiscard]] Point to_plane(double along, std::size_t row) const;
  [[nodiscard]] double across(std::size_t row) const;
};

// Rows that share the region's breadth evenly, as many as fit at `distance` or a little less: the
// outermost lie half a distance inside. No row where the region is empty.
// COSTS: O(points).
[[nodiscard]] RowGrid even_rows_over(const Region& region, Vector direction, double distance);

// The spans of rows inside a region.
class RowCuts {
 public:
  // COSTS: O(points + crossings · log).
  RowCuts(const RowGrid& grid, const Region& region);

  // Disjoint, in ascending order.
  [[nodiscard]] std::span<const RowSpan> operator[](std::size_t row) const {
    return {spans_.data() + starts_[row], starts_[row + 1] - starts_[row]};
  }

 private:
  std::vector<RowSpan> spans_;
  std::vector<std::size_t> starts_;  // by row, into spans_; one more at the end
};

}  // namespace core
