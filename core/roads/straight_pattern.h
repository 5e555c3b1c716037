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

#include "core/roads/fill_pattern.h"  // FillPattern

namespace core {

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
