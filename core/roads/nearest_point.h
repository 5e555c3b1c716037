// The nearest of a set of points that only shrinks: a uniform grid, searched in growing squares
// about the point that is asked for.
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
    std::size_t index = 0;  // which of the owner's points
  };

  // COSTS: O(entries). REQUIRES: fewer than 2^32; best, but not needed, an owner's in one run.
  explicit NearestPoint(std::vector<Entry> entries);

  // Takes all of an owner's points away. REQUIRES: the owner had a point at first.
  void remove_owner(std::size_t owner);

  // The nearest that is left; of equally near ones the first as they were given.
  // COSTS: O(cells) at worst, O(1) where points are spread evenly.
  [[nodiscard]] std::optional<Entry> nearest(Point to) const;

 private:
  [[nodiscard]] std::int64_t column(std::int32_t x) const;
  [[nodiscard]] std::int64_t row(std::int32_t y) const;

  [[nodiscard]] std::size_t cell_of(Point p) const;

  struct Range {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };

  std::vector<Entry> entries_;
  std::vector<Range> of_owner_;          // the entries from its first to its last
  std::vector<std::uint32_t> starts_;    // by cell, into in_cells_
  std::vector<std::uint32_t> ends_;      // by cell: of what is left
  std::vector<std::uint32_t> in_cells_;  // entries
  Point origin_;
  std::int64_t cell_ = 1;
  std::int64_t columns_ = 0;
  std::int64_t rows_ = 0;
};

}  // namespace core
