#include "core/regions/segment_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/check.h"  // RIND_CHECK

namespace core {

namespace {

int sign(std::int64_t value) { return (value > 0) - (value < 0); }

bool touch(const Segment& a, const Segment& b) {
  const int a0 = sign(cross(b.from, b.to, a.from));
  const int a1 = sign(cross(b.from, b.to, a.to));
  const int b0 = sign(cross(a.from, a.to, b.from));
  const int b1 = sign(cross(a.from, a.to, b.to));
  if (a0 == 0 && a1 == 0) {
    return box_of(a).overlaps(box_of(b));
  }
  return a0 * a1 <= 0 && b0 * b1 <= 0;
}

double distance2_units(Point point, const Segment& segment) {
  const double dx = static_cast<double>(segment.to.x) - segment.from.x;
  const double dy = static_cast<double>(segment.to.y) - segment.from.y;
  const double px = static_cast<double>(point.x) - segment.from.x;
  const double py = static_cast<double>(point.y) - segment.from.y;
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0.0;
  const double x = px - t * dx, y = py - t * dy;
  return x * x + y * y;
}

constexpr std::ptrdiff_t kInsertMax = 32;

// Each of the numbers once, in ascending order; those before `first` stay. They come cell by cell,
// in ascending order in each: few are out of place.
void sort_from(std::size_t first, std::vector<std::uint32_t>& numbers) {
  const auto added = numbers.begin() + static_cast<std::ptrdiff_t>(first);
  if (numbers.end() - added > kInsertMax) {
    std::sort(added, numbers.end());
    numbers.erase(std::unique(added, numbers.end()), numbers.end());
    return;
  }
  auto end = added;
  for (auto next = added; next != numbers.end(); ++next) {
    const std::uint32_t number = *next;
    auto place = end;
    while (place != added && place[-1] > number) --place;
    if (place != added && place[-1] == number) continue;
    std::move_backward(place, end, end + 1);
    *place = number;
    ++end;
  }
  numbers.erase(end, numbers.end());
}

}  // namespace

SegmentGrid::SegmentGrid(Length cell, const Region& region)
    : SegmentGrid(cell, edges_of(region.rings())) {}

SegmentGrid::SegmentGrid(Length cell, std::vector<Segment> segments)
    : segments_(std::move(segments)), cell_(cell.units()) {
  RIND_CHECK(cell > Length());
  if (segments_.empty()) return;
  choose_cells();
  enter_segments();
}

void SegmentGrid::choose_cells() {
  Box box;
  for (const Segment& segment : segments_) {
    box.add(segment.from);
    box.add(segment.to);
  }
  origin_ = box.min;
  const std::int64_t wide = std::int64_t{box.max.x} - box.min.x + 1;
  const std::int64_t high = std::int64_t{box.max.y} - box.min.y + 1;
  const auto bound = static_cast<std::int64_t>(segments_.size()) * kCellsPerSegment + 1;
  // First by each side alone, so that the product below does not overflow.
  cell_ = std::max(cell_, std::max(wide, high) / bound + 1);
  while ((wide / cell_ + 1) * (high / cell_ + 1) > bound && cell_ < std::max(wide, high)) {
    cell_ += cell_ / 2 + 1;
  }
  cells_per_unit_ = 1 / static_cast<double>(cell_);
  columns_ = wide / cell_ + 1;
  rows_ = high / cell_ + 1;
}

void SegmentGrid::enter_segments() {
  // Kept for the next grid: a line is followed once only.
  thread_local std::vector<std::uint32_t> cells;
  thread_local std::vector<std::size_t> ends;  // by segment, in cells
  cells.clear();
  ends.clear();
  starts_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  for (const Segment& segment : segments_) {
    walk(segment, [&](std::size_t cell) {
      ++starts_[cell];
      cells.push_back(static_cast<std::uint32_t>(cell));
      return false;
    });
    ends.push_back(cells.size());
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  entries_.resize(cells.size());
  // From the last to the first, so that every cell's segments come out in ascending order.
  std::size_t at = cells.size();
  for (std::size_t i = segments_.size(); i-- > 0;) {
    for (const std::size_t first = i > 0 ? ends[i - 1] : 0; at > first;) {
      entries_[--starts_[cells[--at]]] = static_cast<std::uint32_t>(i);
    }
  }
}

// The cell of a place, the nearest one for a place outside.
std::int64_t SegmentGrid::column(double x) const {
  const double at = (x - origin_.x) * cells_per_unit_;
  return static_cast<std::int64_t>(std::clamp(at, 0.0, static_cast<double>(columns_ - 1)));
}

std::int64_t SegmentGrid::row(double y) const {
  const double at = (y - origin_.y) * cells_per_unit_;
  return static_cast<std::int64_t>(std::clamp(at, 0.0, static_cast<double>(rows_ - 1)));
}

// Row by row: the columns that the line passes within each row, a unit more on either side.
template <typename Visit>
bool SegmentGrid::walk(const Segment& line, const Visit& visit) const {
  const Segment up = line.from.y <= line.to.y ? line : Segment{line.to, line.from};
  const std::int64_t first = row(up.from.y), last = row(up.to.y);
  const double x_from = up.from.x, x_to = up.to.x;
  const double slope =
      first == last ? 0.0 : (x_to - x_from) / (static_cast<double>(up.to.y) - up.from.y);
  for (std::int64_t at_row = first; at_row <= last; ++at_row) {
    double x0 = x_from, x1 = x_to;
    const double bottom = origin_.y + static_cast<double>(at_row * cell_);
    if (at_row > first) x0 = x_from + slope * (bottom - up.from.y);
    if (at_row < last) x1 = x_from + slope * (bottom + static_cast<double>(cell_) - up.from.y);
    const std::int64_t right = column(std::max(x0, x1) + 1);
    for (std::int64_t at = column(std::min(x0, x1) - 1); at <= right; ++at) {
      if (visit(static_cast<std::size_t>(at_row * columns_ + at))) return true;
    }
  }
  return false;
}

bool SegmentGrid::any_within(Point point, Length reach) const {
  if (segments_.empty()) return false;
  const auto r = static_cast<double>(reach.units());
  const std::int64_t right = column(point.x + r), top = row(point.y + r);
  for (std::int64_t at_row = row(point.y - r); at_row <= top; ++at_row) {
    for (std::int64_t at = column(point.x - r); at <= right; ++at) {
      const auto cell = static_cast<std::size_t>(at_row * columns_ + at);
      for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
        if (distance2_units(point, segments_[entries_[i]]) <= r * r) return true;
      }
    }
  }
  return false;
}

void SegmentGrid::collect(const Box& box, std::vector<std::uint32_t>& numbers) const {
  if (segments_.empty()) return;
  const std::size_t before = numbers.size();
  const std::int64_t left = column(box.min.x - 1.0), right = column(box.max.x + 1.0);
  const std::int64_t top = row(box.max.y + 1.0);
  for (std::int64_t at_row = row(box.min.y - 1.0); at_row <= top; ++at_row) {
    const std::int64_t first = at_row * columns_ + left, end = at_row * columns_ + right + 1;
    numbers.insert(numbers.end(), entries_.begin() + starts_[static_cast<std::size_t>(first)],
                   entries_.begin() + starts_[static_cast<std::size_t>(end)]);
  }
  sort_from(before, numbers);
}

void SegmentGrid::collect_along(const Segment& line, std::vector<std::uint32_t>& numbers) const {
  if (segments_.empty()) return;
  const std::size_t before = numbers.size();
  walk(line, [&](std::size_t cell) {
    numbers.insert(numbers.end(), entries_.begin() + starts_[cell],
                   entries_.begin() + starts_[cell + 1]);
    return false;
  });
  sort_from(before, numbers);
}

bool SegmentGrid::crosses(const Segment& line) const {
  if (segments_.empty()) return false;
  return walk(line, [&](std::size_t cell) {
    for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
      if (touch(segments_[entries_[i]], line)) return true;
    }
    return false;
  });
}

}  // namespace core
