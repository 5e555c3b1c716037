#include "core/roads/row_cuts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/rounded.h"  // rounded

namespace core {
namespace {

// Rows may be farther apart than asked for by this share, rather than one more in number.
constexpr double kSpreadShare = 0.02;

// The first row at or above `across`.
std::int64_t row_from(const RowGrid& grid, double across) {
  return static_cast<std::int64_t>(std::ceil((across - grid.first) / grid.distance));
}

// Calls visit(row, along) where a row crosses a ring. An edge's lower end counts as above a row, so
// that every row meets the rings an even number of times.
template <typename Visit>
void each_crossing(const RowGrid& grid, const Region& region, const Visit& visit) {
  const auto count = static_cast<std::int64_t>(grid.count);
  for (const Ring& ring : region.rings()) {
    Vector from = grid.to_rows(ring.back());
    for (const Point point : ring) {
      const Vector to = grid.to_rows(point);
      const auto [low, high] = from.y <= to.y ? std::pair(from, to) : std::pair(to, from);
      const std::int64_t end = std::min(count, row_from(grid, high.y));
      for (std::int64_t row = std::max<std::int64_t>(0, row_from(grid, low.y)); row < end; ++row) {
        const auto at = static_cast<std::size_t>(row);
        const double t = (grid.across(at) - low.y) / (high.y - low.y);
        visit(at, low.x + t * (high.x - low.x));
      }
      from = to;
    }
  }
}

}  // namespace

Vector RowGrid::to_rows(Point point) const {
  const Vector p = to_vector(point);
  return {dot(direction, p), core::cross(direction, p)};
}

Point RowGrid::to_plane(double along, std::size_t row) const {
  const Vector p = direction * along + left_of(direction) * across(row);
  return rounded(p);
}

double RowGrid::across(std::size_t row) const {
  return first + static_cast<double>(row) * distance;
}

RowGrid even_rows_over(const Region& region, Vector direction, double distance) {
  RowGrid grid{direction, 0, distance, 0};
  if (region.empty()) return grid;
  double low = grid.to_rows(region.rings().front().front()).y, high = low;
  for (const Ring& ring : region.rings()) {
    for (const Point point : ring) {
      const double across = grid.to_rows(point).y;
      low = std::min(low, across);
      high = std::max(high, across);
    }
  }
  const double rows = std::max(1.0, std::ceil((high - low) / distance / (1 + kSpreadShare)));
  grid.count = static_cast<std::size_t>(rows);
  grid.distance = (high - low) / rows;
  grid.first = low + grid.distance / 2;
  return grid;
}

RowCuts::RowCuts(const RowGrid& grid, const Region& region) : starts_(grid.count + 1) {
  std::vector<std::size_t> ends(grid.count);  // of each row's crossings
  each_crossing(grid, region, [&](std::size_t row, double) { ++ends[row]; });
  std::size_t all = 0;
  for (std::size_t& end : ends) end = std::exchange(all, all + end);
  std::vector<double> crossings(all);
  each_crossing(grid, region,
                [&](std::size_t row, double along) { crossings[ends[row]++] = along; });
  spans_.reserve(all / 2);
  std::size_t begin = 0;
  for (std::size_t row = 0; row < grid.count; ++row) {
    starts_[row] = spans_.size();
    std::sort(crossings.begin() + static_cast<std::ptrdiff_t>(begin),
              crossings.begin() + static_cast<std::ptrdiff_t>(ends[row]));
    for (; begin + 1 < ends[row]; begin += 2) {
      if (crossings[begin] < crossings[begin + 1]) {
        spans_.push_back({crossings[begin], crossings[begin + 1]});
      }
    }
    begin = ends[row];
  }
  starts_[grid.count] = spans_.size();
}

}  // namespace core
