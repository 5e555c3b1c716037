#include "core/roads/nearest_point.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/check.h"  // RIND_CHECK

namespace core {

namespace {

// Cells are made so large that each holds some two points.
constexpr double kPointsPerCell = 2;

double distance2(Point a, Point b) {
  const double dx = static_cast<double>(a.x) - b.x, dy = static_cast<double>(a.y) - b.y;
  return dx * dx + dy * dy;
}

}  // namespace

NearestPoint::NearestPoint(std::vector<Entry> entries) : entries_(std::move(entries)) {
  if (entries_.empty()) return;
  Box box;
  for (const Entry& entry : entries_) box.add(entry.point);
  origin_ = box.min;
  const double wide = static_cast<double>(box.max.x) - box.min.x + 1;
  const double high = static_cast<double>(box.max.y) - box.min.y + 1;
  const double count = std::max(1.0, static_cast<double>(entries_.size()) / kPointsPerCell);
  // The larger of the two, so that points in one line don't make a grid of empty cells.
  cell_ = 1 + std::llround(std::max(std::sqrt(wide * high / count), std::max(wide, high) / count));
  columns_ = column(box.max.x) + 1;
  rows_ = row(box.max.y) + 1;
  const auto cells = static_cast<std::size_t>(columns_ * rows_);
  std::size_t owners = 0;
  starts_.assign(cells + 1, 0);
  for (const Entry& entry : entries_) {
    owners = std::max(owners, entry.owner + 1);
    ++starts_[cell_of(entry.point) + 1];
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  ends_.assign(starts_.begin(), starts_.end() - 1);
  in_cells_.resize(entries_.size());
  of_owner_.assign(owners, {0, 0});
  for (std::uint32_t i = 0; i < entries_.size(); ++i) {
    in_cells_[ends_[cell_of(entries_[i].point)]++] = i;
    Range& range = of_owner_[entries_[i].owner];
    if (range.end == 0) range.begin = i;
    range.end = i + 1;
  }
}

std::int64_t NearestPoint::column(std::int32_t x) const {
  return (std::int64_t{x} - origin_.x) / cell_;
}

std::int64_t NearestPoint::row(std::int32_t y) const {
  return (std::int64_t{y} - origin_.y) / cell_;
}

std::size_t NearestPoint::cell_of(Point p) const {
  return static_cast<std::size_t>(row(p.y) * columns_ + column(p.x));
}

void NearestPoint::remove_owner(std::size_t owner) {
  RIND_CHECK(owner < of_owner_.size());
  for (std::uint32_t i = of_owner_[owner].begin; i < of_owner_[owner].end; ++i) {
    if (entries_[i].owner != owner) continue;
    const std::size_t cell = cell_of(entries_[i].point);
    const auto end = in_cells_.begin() + ends_[cell];
    const auto found = std::find(in_cells_.begin() + starts_[cell], end, i);
    if (found == end) continue;
    *found = *(end - 1);
    --ends_[cell];
  }
  of_owner_[owner] = {0, 0};
}

std::optional<NearestPoint::Entry> NearestPoint::nearest(Point to) const {
  const std::int64_t at_column = std::clamp<std::int64_t>(column(to.x), 0, columns_ - 1);
  const std::int64_t at_row = std::clamp<std::int64_t>(row(to.y), 0, rows_ - 1);
  std::optional<std::uint32_t> best;
  double best_distance2 = 0;
  const auto look = [&](std::int64_t c, std::int64_t r) {
    if (c < 0 || c >= columns_ || r < 0 || r >= rows_) return;
    const auto cell = static_cast<std::size_t>(r * columns_ + c);
    for (std::uint32_t at = starts_[cell]; at < ends_[cell]; ++at) {
      const std::uint32_t i = in_cells_[at];
      const double d2 = distance2(entries_[i].point, to);
      if (best && (d2 > best_distance2 || (d2 == best_distance2 && i > *best))) continue;
      best = i;
      best_distance2 = d2;
    }
  };
  for (std::int64_t ring = 0; ring <= std::max(columns_, rows_); ++ring) {
    // Whatever lies in this square's edge or beyond is at least so far away.
    const auto least = static_cast<double>((ring - 1) * cell_);
    if (best && ring > 0 && least > 0 && least * least > best_distance2) break;
    for (std::int64_t r = at_row - ring; r <= at_row + ring; ++r) {
      const bool whole = r == at_row - ring || r == at_row + ring;
      const std::int64_t step = whole || ring == 0 ? 1 : 2 * ring;
      for (std::int64_t c = at_column - ring; c <= at_column + ring; c += step) look(c, r);
    }
  }
  if (!best) return std::nullopt;
  return entries_[*best];
}

}  // namespace core
