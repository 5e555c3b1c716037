// Polygons along circular arcs.
//
//     between lines that touch the arc           elsewhere
//
//     line ───●────╮   the vertices lie outside   the vertices lie on the arc, the chords inside
//              ╲   │   by the tolerance, and the
//               ╲──●   middles of edges as far inside: fewer vertices by a third, and where the
//                  │   arc is small a single one, where the lines meet
//
// Every later operation on an inset pays for its vertices.
#pragma once

#include "core/geometry.h"  // Point, Ring
#include "core/vector.h"    // Vector

namespace core {

// An arc as its two ends about its centre. Both were rounded, so the radius goes evenly from the
// one to the other.
struct Arc {
  Vector centre;
  Vector from;
  Vector to;
  double side;  // 1: counter-clockwise; -1: clockwise
};

// For many arcs at one tolerance, in units.
class ArcPolygon {
 public:
  // REQUIRES: tolerance > 0.
  explicit ArcPolygon(double tolerance) : tolerance_(tolerance) {}

  // Appends the arc's points after its first and before its last.
  void add_chords(const Arc& arc, Ring& ring);

  // Appends what stands for the arc with its ends, where the lines before and after it touch it:
  // from a point on the one to a point on the other. False, and nothing is appended, where they
  // don't, to 3 units.
  [[nodiscard]] bool add_between(Point before, const Arc& arc, Point after, Ring& ring);

 private:
  void set_radius(double radius);
  void find_angles();
  void add_outside(const Arc& arc, Ring& ring);

  double tolerance_;
  double radius_ = 0;
  double inside_ = 0;   // the cosine of half a chord's angle
  double outside_ = 0;  // the cosine of end_angle_
  // Found where they are needed first.
  double end_angle_ = 0;  // from where a line touches the arc to the first vertex, at most
  double half_step_ = 0;  // half the angle between two vertices, at most
  bool angles_found_ = false;
};

}  // namespace core
