// Pieces of the border of one cell, while they are sought.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace core {

// A stretch of a site on which discs of radius `floor` touch nothing else, and those up to `cap`
// are sought.
struct Stretch {
  double from = 0;
  double to = 0;
  double cap = 0;
  double floor = 0;
};

// What is lowest between two parameters.
template <typename Curve>
struct Border {
  double from = 0;
  double to = 0;
  Curve curve;
};

// In order, and pieces that touch the same site as one.
template <typename Curve>
void join(std::vector<Border<Curve>>& border) {
  std::sort(border.begin(), border.end(),
            [](const auto& a, const auto& b) { return a.from < b.from; });
  std::size_t kept = 0;
  for (const Border<Curve>& piece : border) {
    if (kept > 0 && border[kept - 1].curve.site == piece.curve.site) {
      border[kept - 1].to = piece.to;
    } else {
      border[kept++] = piece;
    }
  }
  border.resize(kept);
}

}  // namespace core
