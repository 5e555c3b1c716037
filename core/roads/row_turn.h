// The plane turned so that the rows of a fill are horizontal.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/geometry.h"      // Point
#include "core/trigonometry.h"  // cosine, sine

namespace core {

class RowTurn {
 public:
  // The rows' angle against the x axis.
  explicit RowTurn(double degrees)
      : cosine_(cosine(degrees * std::numbers::pi / 180)),
        sine_(sine(degrees * std::numbers::pi / 180)) {}

  // Along the rows, and across.
  [[nodiscard]] std::array<double, 2> to_rows(Point p) const {
    return {cosine_ * p.x + sine_ * p.y, -sine_ * p.x + cosine_ * p.y};
  }
  [[nodiscard]] Point to_plane(double along, double across) const {
    return {static_cast<std::int32_t>(std::lround(cosine_ * along - sine_ * across)),
            static_cast<std::int32_t>(std::lround(sine_ * along + cosine_ * across))};
  }

 private:
  double cosine_;
  double sine_;
};

}  // namespace core
