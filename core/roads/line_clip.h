// Clips open lines with a region: the pieces that lie inside, and where on the region's contours
// each of them begins and ends.
//
//        ╭─────────╮
//     ───●━━━━━━━━━●───────●━━━━●───      a piece knows the places of its two ends along the rings,
//        │         │       │    │         so that neighbours there are found by sorting
//
// A line changes between outside and inside where it crosses an edge. Which edges it crosses is
// decided by exact predicates, a point on an edge counting as on its right: so a line that begins
// outside crosses the contours an even number of times if it ends outside.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"              // Point, Segment
#include "core/regions/region.h"        // Region
#include "core/regions/segment_grid.h"  // SegmentGrid
#include "core/units.h"                 // Length

namespace core {

// A place on a region's contours: units along the ring, from its first point.
struct BoundaryPlace {
  std::size_t ring = 0;
  double along = 0;
};

struct BoundaryPoint {
  Point at;
  BoundaryPlace place;
};

struct ClippedLine {
  std::vector<Point> points;  // 2 or more
  BoundaryPlace from, to;
};

class LineClipper {
 public:
  // Keeps a reference to the region. COSTS: O(points).
  explicit LineClipper(const Region& region);

  // Appends the line's pieces in their order along it.
  // REQUIRES: the line begins and ends outside of the region's box.
  // COSTS: O(points + cells passed + crossings · log).
  void clip(const std::vector<Point>& line, std::vector<ClippedLine>& pieces) const;

  // Share of the way from a to b at which the first contour is crossed; above 1: none is.
  [[nodiscard]] double first_crossing(Point a, Point b) const;

  // Appends the places where contours are crossed on the way from a to b, in their order.
  void append_crossings(Point a, Point b, std::vector<BoundaryPoint>& places) const;

  // The place nearest to a point; nothing where none is within reach.
  // COSTS: O(edges about the reach).
  [[nodiscard]] std::optional<BoundaryPoint> nearest(Point point, Length reach) const;

  // The contours' points from one place on a ring to another on the same: forwards, or backwards.
  // The ends are left out.
  void append_way(const BoundaryPlace& from, const BoundaryPlace& to, bool forwards,
                  std::vector<Point>& points) const;

  [[nodiscard]] double ring_length(std::size_t ring) const { return ring_lengths_[ring]; }

 private:
  struct Crossing {
    double share = 0;  // of the segment's way
    std::uint32_t edge = 0;
  };

  void crossings(const Segment& segment, std::vector<Crossing>& found) const;
  [[nodiscard]] BoundaryPlace place_on(std::uint32_t edge, Point at) const;

  const Region& region_;
  std::vector<Segment> edges_;
  std::vector<std::uint32_t> ring_of_;  // by edge
  std::vector<double> starts_;          // by edge: units along its ring
  std::vector<double> ring_lengths_;
  SegmentGrid grid_;
};

}  // namespace core
