// Straight rows in one direction or several:
//
//     lines       one direction, turned by 90° from layer to layer
//     grid        two directions in every layer
//     triangles   three directions, 60° from one another
//     cubic       three directions; each row moves sideways as the layers go up, so that the three
//                 families are planes at right angles to one another: cubes that stand on a corner
//
// With k directions in a layer, rows of one direction are k times as far apart.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry.h"            // Box, Segment
#include "core/roads/fill_pattern.h"  // FillPattern

namespace core {

struct PatternRow {
  std::int64_t number = 0;
  Segment line;
};

// Rows at (number + ½) · distance + shift, turned by the angle: those that meet the box, from the
// lowest up, each a little longer than the box. REQUIRES: a box that is not empty, distance > 0.
[[nodiscard]] std::vector<PatternRow> rows_over(const Box& box, double degrees, double distance,
                                                double shift);

class StraightPattern final : public FillPattern {
 public:
  enum class Kind { kLines, kGrid, kTriangles, kCubic };

  explicit StraightPattern(Kind kind) : kind_(kind) {}

  // COSTS: O(rows).
  [[nodiscard]] PatternLines lines(const PatternPlace& place) const override;

 private:
  Kind kind_;
};

}  // namespace core
