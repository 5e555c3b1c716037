#include "core/roads/row_cuts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace core {
namespace {

// Rows may be farther apart than asked for by this share, rather than one more in number.
constexpr double kSpreadShare = 0.02;

// The first row at or above `across`.
std::int64_t row_from(const RowGrid& grid, double across) {
  return static_cast<std::int64_t>(std::ceil((across - grid.first) / grid.distance));
}

}  // namespace

Vector RowGrid::to_rows(Point point) const {
  const Vector p = to_vector(point);
  return {dot(direction, p), core::cross(direction, p)};
}

Point RowGrid::to_plane(double along, std::size_t row) const {
  const Vector p = direction * along + left_of(direction) * across(row);
  return {static_cast<std::int32_t>(std::lround(p.x)), static_cast<std::int32_t>(std::lround(p.y))};
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

// An edge's lower end counts as above a row, so that every row meets the rings an even number of
// times.
std::vector<std::vector<RowSpan>> cut_rows(const RowGrid& grid, const Region& region) {
  const auto count = static_cast<std::int64_t>(grid.count);
  std::vector<std::vector<double>> crossings(grid.count);
  for (const Ring& ring : region.rings()) {
    Vector from = grid.to_rows(ring.back());
    for (const Point point : ring) {
      const Vector to = grid.to_rows(point);
      const auto [low, high] = from.y <= to.y ? std::pair(from, to) : std::pair(to, from);
      const std::int64_t end = std::min(count, row_from(grid, high.y));
      for (std::int64_t row = std::max<std::int64_t>(0, row_from(grid, low.y)); row < end; ++row) {
        const double t = (grid.across(static_cast<std::size_t>(row)) - low.y) / (high.y - low.y);
        crossings[static_cast<std::size_t>(row)].push_back(low.x + t * (high.x - low.x));
      }
      from = to;
    }
  }
  std::vector<std::vector<RowSpan>> rows(grid.count);
  for (std::size_t row = 0; row < grid.count; ++row) {
    std::vector<double>& at = crossings[row];
    std::sort(at.begin(), at.end());
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
      if (at[i] < at[i + 1]) rows[row].push_back({at[i], at[i + 1]});
    }
  }
  return rows;
}

}  // namespace core
