// The plane turned so that the rows of a fill are horizontal.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>

#include "core/geometry.h"      // Box, Point
#include "core/rounded.h"       // rounded
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
    return {rounded(cosine_ * along - sine_ * across), rounded(sine_ * along + cosine_ * across)};
  }

 private:
  double cosine_;
  double sine_;
};

// The turned box round a box.
struct TurnedBox {
  double low = 0, high = 0;    // along the rows
  double bottom = 0, top = 0;  // across
};

[[nodiscard]] inline TurnedBox turned_box(const Box& box, const RowTurn& turn) {
  const auto [along, across] = turn.to_rows(box.min);
  TurnedBox turned{along, along, across, across};
  for (const Point corner : {Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}}) {
    const auto [x, y] = turn.to_rows(corner);
    turned.low = std::min(turned.low, x);
    turned.high = std::max(turned.high, x);
    turned.bottom = std::min(turned.bottom, y);
    turned.top = std::max(turned.top, y);
  }
  return turned;
}

}  // namespace core
