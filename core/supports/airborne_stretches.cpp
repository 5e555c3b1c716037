#include "core/supports/airborne_stretches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/regions/polyline.h"  // between, distance_mm, length_mm
#include "core/rounded.h"           // rounded

namespace core {
namespace {

// Places that are looked at are at most this far apart.
constexpr double kStep_mm = 0.2;

// Octagons of a strip are so far apart, as a share of their radius.
constexpr double kStripStep = 0.6;

// Steps of a ring, each with whether it is held.
struct Steps {
  std::vector<Point> points;
  std::vector<bool> held;
};

Steps steps_of(const Ring& ring, const PointLocation& below) {
  Steps steps;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i], to = ring[i + 1 < ring.size() ? i + 1 : 0];
    const auto count =
        std::max(std::size_t{1}, static_cast<std::size_t>(distance_mm(from, to) / kStep_mm));
    for (std::size_t step = 0; step < count; ++step) {
      const double share = static_cast<double>(step) / static_cast<double>(count);
      steps.points.push_back(between(from, to, share));
      steps.held.push_back(below.contains(steps.points.back()));
    }
  }
  return steps;
}

bool holds(const std::vector<Point>& stretch, const Settings& settings) {
  const double mm = length_mm(stretch, false);
  if (mm <= kStretchHeld_mm) return true;
  return mm <= settings.bridge_max.mm() &&
         mm <= kBentRatio * distance_mm(stretch.front(), stretch.back());
}

// A regular octagon with its sides at `reach`.
Ring octagon(Point centre, double reach) {
  const auto r = rounded(reach);
  const auto k = rounded(reach * (std::sqrt(2.0) - 1));
  return {{centre.x + r, centre.y - k}, {centre.x + r, centre.y + k}, {centre.x + k, centre.y + r},
          {centre.x - k, centre.y + r}, {centre.x - r, centre.y + k}, {centre.x - r, centre.y - k},
          {centre.x - k, centre.y - r}, {centre.x + k, centre.y - r}};
}

}  // namespace

std::vector<std::vector<Point>> airborne_stretches(const Ring& ring, const PointLocation& below,
                                                   const Settings& settings) {
  std::vector<std::vector<Point>> found;
  const Steps steps = steps_of(ring, below);
  const std::size_t count = steps.points.size();
  std::size_t start = 0;
  while (start < count && !steps.held[start]) ++start;
  if (start == count) {
    std::vector<Point> around = steps.points;
    around.push_back(around.front());
    if (!holds(around, settings)) found.push_back(std::move(around));
    return found;
  }
  std::vector<Point> stretch;
  for (std::size_t i = 1; i <= count; ++i) {
    const std::size_t at = (start + i) % count;
    if (!steps.held[at]) {
      stretch.push_back(steps.points[at]);
      continue;
    }
    if (stretch.size() > 1 && !holds(stretch, settings)) found.push_back(std::move(stretch));
    stretch.clear();
  }
  return found;
}

void add_strips(const std::vector<std::vector<Point>>& lines, Length reach,
                std::vector<Ring>& strips) {
  const auto radius = static_cast<double>(reach.units());
  for (const std::vector<Point>& line : lines) {
    std::optional<Point> last;
    for (const Point point : line) {
      if (last && distance_units(*last, point) < kStripStep * radius) continue;
      strips.push_back(octagon(point, radius));
      last = point;
    }
    strips.push_back(octagon(line.back(), radius));
  }
}

}  // namespace core
