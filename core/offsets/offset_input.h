// A region's contours as the polygon offset reads them: edges and corners in double coordinates,
// all seen from one side.
//
// Offsets always go to the left of the edges. For outward offsets the plane is mirrored (y -> -y)
// when the contours are loaded, which puts the outside on the left. Nothing else differs.
//
// Some decisions are exact. Coordinates are integers relative to the region's box, so differences
// are exact in a double. exact_cross() and exact_dot() round once at most, so that their sign, and
// whether they are 0, is always right:
//   corner of e -> g     cross(e, g) < 0: reflex, it raises an arc; > 0: convex, it raises nothing
//   collinear run        cross = 0: the corner is dropped, one edge stands for the run
//   equal points         where contours touch at a corner, mend_touching() links them again, so
//                        that each corner is one true wedge of the inside; at most one of the
//                        wedges at a point is reflex, and it owns the point's arc
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry.h"        // Point
#include "core/regions/region.h"  // Region

namespace core {

struct OffsetEdge {
  double x, y;    // from here
  double dx, dy;  // to the end
  double length, inverse_length;
  std::int32_t end_corner;  // where it ends: corner i is where edge i starts
  std::int32_t previous;    // edge before it along the contour
  std::int32_t next;        // edge after it
  std::int32_t run;         // edges of one run never trim one another (offset_runs.h)
};

// The corner where the edge of the same index starts.
struct OffsetCorner {
  double half_tangent;  // tan(turn / 2), the turn counted from 0 to 180° either way
  std::int32_t owner;   // the corner whose arc stands for this point's
  bool reflex;
};

// A reflex corner's arc: the unit vector halfway between its ends' normals, tan(turn / 4).
struct OffsetArc {
  double middle_x, middle_y, quarter_tangent;
};

// cross and dot of (ax, ay), (bx, by), whose coordinates are integers below 2^30.
// With kWide = false they must be below 2^26: the plain products are exact then.
template <bool kWide>
inline double exact_cross(double ax, double ay, double bx, double by) {
  if constexpr (kWide) {
    return static_cast<double>(static_cast<std::int64_t>(ax) * static_cast<std::int64_t>(by) -
                               static_cast<std::int64_t>(ay) * static_cast<std::int64_t>(bx));
  } else {
    return ax * by - ay * bx;
  }
}
template <bool kWide>
inline double exact_dot(double ax, double ay, double bx, double by) {
  return exact_cross<kWide>(ax, ay, -by, bx);
}

class OffsetInput {
 public:
  // COSTS: O(points); allocates only when a region is larger than all before.
  void load(const Region& region, bool mirrored);
  // REQUIRES: `box` is the region's.
  void load(const Region& region, const Box& box, bool mirrored);

  // Links the corners at equal points by angle. COSTS: O(n log n); needed only when contours touch.
  void mend_touching();

  [[nodiscard]] const std::vector<OffsetEdge>& edges() const { return edges_; }
  // For find_runs() only.
  [[nodiscard]] std::vector<OffsetEdge>& edges_to_mark() { return edges_; }
  [[nodiscard]] const std::vector<OffsetCorner>& corners() const { return corners_; }
  // REQUIRES: the corner is reflex.
  [[nodiscard]] OffsetArc arc(std::int32_t corner) const;
  // Corners were linked again: neighbouring edges need not follow one another in memory.
  [[nodiscard]] bool mended() const { return mended_; }
  // Differences of coordinates need the wide products.
  [[nodiscard]] bool wide() const { return wide_; }

  // The grid point nearest to (x, y); corners come back exactly.
  [[nodiscard]] Point to_grid(double x, double y) const;

 private:
  void load_ring(const Ring& ring);
  void set_corner(std::size_t index);
  void mend_point(std::size_t first, std::size_t last);

  std::vector<OffsetEdge> edges_;
  std::vector<OffsetCorner> corners_;
  std::vector<std::int32_t> by_point_;  // scratch of mend_touching()
  std::vector<std::int32_t> around_;    // scratch of mend_point()
  std::int64_t origin_x_ = 0, origin_y_ = 0;
  double mirror_ = 1;
  bool wide_ = false;
  bool mended_ = false;
};

}  // namespace core
