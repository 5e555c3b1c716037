#include "core/bed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace core {
namespace {

std::int32_t coordinate(std::int64_t units) { return static_cast<std::int32_t>(units); }

double length_of(std::int64_t x, std::int64_t y) {
  const auto dx = static_cast<double>(x), dy = static_cast<double>(y);
  return std::sqrt(dx * dx + dy * dy);
}

double distance(Point point, Point from, Point to) {
  const std::int64_t ex = std::int64_t{to.x} - from.x, ey = std::int64_t{to.y} - from.y;
  const std::int64_t px = std::int64_t{point.x} - from.x, py = std::int64_t{point.y} - from.y;
  const std::int64_t along = ex * px + ey * py, whole = ex * ex + ey * ey;
  if (along <= 0 || whole == 0) return length_of(px, py);
  if (along >= whole) return length_of(std::int64_t{point.x} - to.x, std::int64_t{point.y} - to.y);
  return static_cast<double>(std::abs(cross(from, to, point))) / length_of(ex, ey);
}

// Whether the edge has points strictly inside the box.
bool enters(Point from, Point to, const Box& box) {
  if (std::max(from.x, to.x) <= box.min.x || std::min(from.x, to.x) >= box.max.x) return false;
  if (std::max(from.y, to.y) <= box.min.y || std::min(from.y, to.y) >= box.max.y) return false;
  const std::array<Point, 4> corners = {box.min, Point{box.max.x, box.min.y}, box.max,
                                        Point{box.min.x, box.max.y}};
  bool left = false, right = false;
  for (const Point corner : corners) {
    const std::int64_t side = cross(from, to, corner);
    left |= side > 0;
    right |= side < 0;
  }
  return left && right;
}

std::int64_t doubled_area(const Ring& ring) {
  std::int64_t area = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) area += cross(ring[0], ring[i], ring[i + 1]);
  return area;
}

}  // namespace

Bed::Bed(const Settings& settings)
    : far_corner_{coordinate(settings.bed_x.units()), coordinate(settings.bed_y.units())},
      rectangular_(settings.bed_shape.empty()) {
  if (rectangular_) {
    outline_ = {{0, 0}, {far_corner_.x, 0}, far_corner_, {0, far_corner_.y}};
    return;
  }
  outline_.reserve(settings.bed_shape.size());
  for (const Point at : settings.bed_shape) {
    outline_.push_back({coordinate(at.x - settings.bed_origin_x.units()),
                        coordinate(at.y - settings.bed_origin_y.units())});
  }
  if (doubled_area(outline_) < 0) std::reverse(outline_.begin(), outline_.end());
}

bool Bed::within_outline(Point point, double reach) const {
  // Half a unit for the rounding of the outline's corners.
  constexpr double kRounding = 0.5;
  bool inside = false;
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    const Point a = outline_[i], b = outline_[i + 1 < outline_.size() ? i + 1 : 0];
    nearest = std::min(nearest, distance(point, a, b));
    if ((a.y > point.y) == (b.y > point.y)) continue;
    // The edge crosses the ray to the right if the point is left of its upward direction.
    const std::int64_t side = cross(a, b, point);
    if (b.y > a.y ? side > 0 : side < 0) inside = !inside;
  }
  return inside ? nearest + kRounding >= reach : reach <= kRounding && nearest <= kRounding;
}

bool Bed::holds(Point point, Length reach) const {
  const std::int64_t r = reach.units();
  if (point.x < r || point.y < r || point.x + r > far_corner_.x || point.y + r > far_corner_.y) {
    return false;
  }
  return rectangular_ || within_outline(point, static_cast<double>(r));
}

bool Bed::holds(const Box& box) const {
  if (box.empty() || box.min.x < 0 || box.min.y < 0 || box.max.x > far_corner_.x ||
      box.max.y > far_corner_.y) {
    return false;
  }
  if (rectangular_) return true;
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    if (enters(outline_[i], outline_[i + 1 < outline_.size() ? i + 1 : 0], box)) return false;
  }
  return within_outline({coordinate((std::int64_t{box.min.x} + box.max.x) / 2),
                         coordinate((std::int64_t{box.min.y} + box.max.y) / 2)},
                        0);
}

Point Bed::place_near(Point asked, Length edge) const {
  constexpr std::int64_t kSteps = 1 << 20;
  const Point middle{far_corner_.x / 2, far_corner_.y / 2};
  const auto on_way = [&](std::int64_t step) {
    const auto between = [&](std::int64_t from, std::int64_t to) {
      return coordinate(from + (to - from) * step / kSteps);
    };
    return Point{between(asked.x, middle.x), between(asked.y, middle.y)};
  };
  if (holds(asked, edge)) return asked;
  if (!holds(middle, edge)) return edge > Length() ? place_near(asked, {}) : outline_.front();
  std::int64_t off = 0, on = kSteps;
  while (on - off > 1) {
    const std::int64_t between = (off + on) / 2;
    (holds(on_way(between), edge) ? on : off) = between;
  }
  return on_way(on);
}

}  // namespace core
