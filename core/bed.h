// The bed that the nozzle may be over: what lies within its outline, and within bed_x and bed_y,
// which may be less than the outline's width and depth where the machine's axes are shorter.
//
// All points count from the bed's front left corner, the corner of the outline's bounding box.
#pragma once

#include "core/geometry.h"  // Box, Point, Ring
#include "core/settings.h"  // Settings
#include "core/units.h"     // Length

namespace core {

class Bed {
 public:
  // REQUIRES: bed_shape is empty, or a simple polygon of at most kBedCornersMax corners.
  explicit Bed(const Settings& settings);

  // Counter-clockwise.
  [[nodiscard]] const Ring& outline() const { return outline_; }

  // Whether all that is nearer than `reach` to the point lies on the bed. COSTS: O(corners).
  [[nodiscard]] bool holds(Point point, Length reach = {}) const;

  // Whether the whole box lies on the bed; false for an empty one. COSTS: O(corners).
  [[nodiscard]] bool holds(const Box& box) const;

  // The place nearest to `asked`, on the straight way from there to the middle of the bed's box,
  // that keeps `edge` away from the outline; if there is none, one on the outline.
  [[nodiscard]] Point place_near(Point asked, Length edge) const;

 private:
  [[nodiscard]] bool within_outline(Point point, double reach) const;

  Point far_corner_;  // of bed_x by bed_y
  Ring outline_;
  bool rectangular_ = true;
};

}  // namespace core
