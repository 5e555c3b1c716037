// A part of the plane bounded by rings: a slice, an offset, a wall.
//
// A region is always clean:
//   - every point of the plane has winding number 0 (outside) or 1 (inside);
//   - outer contours run counter-clockwise, holes clockwise;
//   - contours do not cross or overlap, themselves or one another; they may touch at points;
//   - no ring has fewer than 3 points, repeated neighbours, or zero area.
// clean() in boolean.h makes a region of any other rings.
#pragma once

#include <utility>
#include <vector>

#include "core/geometry.h"  // Ring, Box

namespace core {

class Region {
 public:
  Region() = default;

  // REQUIRES: the rings are clean as stated above (checked only in tests, by is_clean()).
  static Region from_clean_rings(std::vector<Ring> rings) { return Region(std::move(rings)); }

  [[nodiscard]] const std::vector<Ring>& rings() const { return rings_; }
  [[nodiscard]] bool empty() const { return rings_.empty(); }
  [[nodiscard]] std::size_t point_count() const;

  // mm². COSTS: O(points).
  [[nodiscard]] double area_mm2() const;
  // mm, outer contours and holes. COSTS: O(points).
  [[nodiscard]] double perimeter_mm() const;
  // COSTS: O(points).
  [[nodiscard]] Box box() const;
  // True inside and on the boundary. COSTS: O(points).
  [[nodiscard]] bool contains(Point point) const;

  // Same rings, in the same order from the same starting points.
  bool operator==(const Region&) const = default;

 private:
  explicit Region(std::vector<Ring> rings) : rings_(std::move(rings)) {}
  std::vector<Ring> rings_;
};

// Twice the ring's signed area in square units; positive when counter-clockwise.
[[nodiscard]] double doubled_area_units(const Ring& ring);

// One connected piece of a region.
struct Island {
  Ring outer;
  std::vector<Ring> holes;
};

// Appends the outer ring, then the holes.
void append_rings(Island island, std::vector<Ring>& rings);
[[nodiscard]] Region region_of(Island island);

// The connected pieces, each with its own holes; islands within holes are islands of their own.
// COSTS: O(rings · points) at worst.
[[nodiscard]] std::vector<Island> islands(const Region& region);

}  // namespace core
