// Gyroid: the sheet  sin x cos y + sin y cos z + sin z cos x = 0,  alike in all directions, in one
// piece, and without any crossing within a layer.
//
// At a height z the equation is  A cos y + B sin y = −C  for each x, so that y = φ ± arccos(−C / r)
// with r and φ the length and the angle of (A, B). Where |sin z| > |cos z|, x is solved for instead
// of y: then r is never below |C|, and all lines run on for ever.
//
// SOURCE: Schoen, "Infinite periodic minimal surfaces without self-intersections", NASA TN D-5541,
// 1970; its sheet is within 1 % of this level set.
#pragma once

#include "core/roads/fill_pattern.h"  // FillPattern

namespace core {

class GyroidPattern final : public FillPattern {
 public:
  // COSTS: O(points): kStepsPerCell a cell.
  [[nodiscard]] PatternLines lines(const PatternPlace& place) const override;

 private:
  static constexpr int kStepsPerCell = 32;
};

}  // namespace core
