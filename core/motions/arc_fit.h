// Arcs of circles that stand for runs of a road's short segments.
//
//     o──o                         ╭──╮     One arc for five segments: it ends where they end, and
//    o    o──────o     ──>        ╭    ╰────o   passes each of their points, and the middle of each
//   o                             o             segment, within the tolerance.
//
// Greedy: from each point, the longest run that one arc fits, found by doubling and halving. The
// arc through the run's ends has one free number, where its centre lies on their bisector. Least
// squares of the points' distances from the circle give it in one pass.
//
// The points' angles about the centre grow from one to the next. So what holds for the radii holds
// for the lines: each is within the tolerance of the other (Hausdorff distance).
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry.h"  // Point
#include "core/units.h"     // Length

namespace core {

// Fewer segments are as short as straight lines.
inline constexpr std::size_t kArcSegmentsMin = 3;
// Controllers draw an arc by straight pieces of 0.1 mm at least (Marlin's MIN_ARC_SEGMENT_MM).
inline constexpr double kArcRadiusMin_mm = 0.1;
inline constexpr double kArcLengthMin_mm = 0.2;
// Beyond this, a controller's 32-bit floats move the arc.
inline constexpr double kArcRadiusMax_mm = 1'000;
// Two arcs make any circle, and none ends near where it starts.
inline constexpr double kArcSweepMax_degrees = 240;

// One piece of the path: straight, or an arc.
struct RoadPiece {
  Point to;
  bool is_arc = false;
  bool clockwise = false;
  Point centre;             // of an arc
  double length_mm = 0;     // of the way
  double laid_over_mm = 0;  // of the segments that it stands for
};

class ArcFitter {
 public:
  // REQUIRES: tolerance >= 0; with 0 there are no arcs.
  explicit ArcFitter(Length tolerance);

  // The way from the first point through all others, back to the first where `closed`. Repeated
  // points are left out. Valid until the next call.
  //
  // ENSURES: pieces and polyline are within the tolerance of one another; straight pieces are the
  // polyline's segments; laid_over_mm sums up to its length; the same points the other way round,
  // none repeated, give the same pieces the other way round.
  // COSTS: O(n log n), O(n) where nothing is round; no allocation once it has seen a road as long.
  [[nodiscard]] const std::vector<RoadPiece>& pieces(const std::vector<Point>& points, bool closed);

 private:
  struct Node {
    Point point;
    double x = 0, y = 0;  // from the first node
    double way = 0;       // along the polyline, from the first node
  };
  struct Arc {
    Point centre;
    bool clockwise = false;
    double length = 0;  // of the way
    double height = 0;  // over the chord
  };
  struct Run {
    std::size_t first = 0;
    std::size_t last = 0;
    Arc arc;
    bool is_arc = false;
  };

  void take(const std::vector<Point>& points, bool closed);
  void find_runs();
  [[nodiscard]] Run longest_run(std::size_t first) const;
  [[nodiscard]] bool fits(std::size_t first, std::size_t last, Arc& arc) const;
  [[nodiscard]] bool near_circle(std::size_t first, std::size_t last, double x, double y,
                                 double radius, double side) const;
  [[nodiscard]] RoadPiece piece(const Run& run) const;

  double tolerance_;  // units
  bool backwards_ = false;
  std::vector<Node> nodes_;
  std::vector<Run> runs_;
  std::vector<RoadPiece> pieces_;
};

}  // namespace core
