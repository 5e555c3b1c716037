// The nearest of a set of points from which points are taken away: a uniform grid, searched in
// growing squares about the place that asks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"  // Point

namespace core {

class NearestPoint {
 public:
  struct Entry {
    Point point;
    std::size_t owner = 0;  // what the caller knows it by
    std::size_t place = 0;  // which of the owner's points
  };

  explicit NearestPoint(std::vector<Entry> entries);

  // Takes all of an owner's points away. REQUIRES: the owner had a point at the begin.
  void remove_owner(std::size_t owner);

  // The nearest that is left; of equally near ones the first as they were given.
  // COSTS: O(cells) at worst, O(1) where points are spread evenly.
  [[nodiscard]] std::optional<Entry> nearest(Point to) const;

 private:
  [[nodiscard]] std::int64_t column(std::int32_t x) const;
  [[nodiscard]] std::int64_t row(std::int32_t y) const;

  std::vector<Entry> entries_;
  std::vector<std::vector<std::size_t>> of_owner_;  // entries
  std::vector<std::vector<std::size_t>> cells_;     // entries left, in the order given
  Point origin_;
  std::int64_t cell_ = 1;
  std::int64_t columns_ = 0;
  std::int64_t rows_ = 0;
};

}  // namespace core
