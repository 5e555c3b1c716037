#include "core/roads/bead_roads.h"

#include <algorithm>
#include <cmath>

#include "core/regions/simplify.h"  // kSimplifyRunMax
#include "core/rounded.h"           // rounded
#include "core/trigonometry.h"      // hypotenuse

namespace core {
namespace {

// A road whose width changes by no more than this has one width, and can be merged and drawn as
// arcs.
constexpr Length kOneWidth = Length::from_units(50);

// A closed bead that is shorter than this many times its width is a blot.
constexpr double kLoopWidthsMin = 1;

// How far points are from where a road from a to b would have them, in shares of the tolerances,
// squared.
class Chord {
 public:
  Chord(const BeadPoint& a, const BeadPoint& b, double tolerance)
      : a_(a),
        along_(b.at - a.at),
        widens_(b.room - a.room),
        per_length2_(dot(along_, along_) > 0 ? 1 / dot(along_, along_) : 0),
        per_tolerance2_(1 / (tolerance * tolerance)) {}

  [[nodiscard]] double off2(const BeadPoint& p) const {
    const Vector away = p.at - a_.at;
    const double share = std::clamp(dot(away, along_) * per_length2_, 0.0, 1.0);
    const Vector rest = away - along_ * share;
    const double width = (p.room - (a_.room + share * widens_)) * kPerWidthTolerance;
    return std::max(dot(rest, rest) * per_tolerance2_, width * width);
  }

 private:
  static constexpr double kPerWidthTolerance = 1 / static_cast<double>(kBeadWidthTolerance.units());

  const BeadPoint& a_;
  Vector along_;
  double widens_;
  double per_length2_;
  double per_tolerance2_;
};

// Ramer–Douglas–Peucker with the width as a third coordinate.
void keep_needed(const std::vector<BeadPoint>& points, std::size_t first, std::size_t last,
                 double tolerance, std::vector<std::uint8_t>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  for (std::size_t i = first; i < last; i += kSimplifyRunMax) {
    const std::size_t end = std::min(last, i + kSimplifyRunMax);
    kept[i] = kept[end] = 1;
    runs.emplace_back(i, end);
  }
  while (!runs.empty()) {
    const auto [from, to] = runs.back();
    runs.pop_back();
    double worst = 1;
    std::size_t at = from;
    const Chord chord(points[from], points[to], tolerance);
    for (std::size_t i = from + 1; i < to; ++i) {
      const double there = chord.off2(points[i]);
      if (there <= worst) continue;
      worst = there;
      at = i;
    }
    if (at == from) continue;
    kept[at] = 1;
    runs.emplace_back(from, at);
    runs.emplace_back(at, to);
  }
}

std::size_t farthest_from_first(const std::vector<BeadPoint>& points) {
  std::size_t farthest = 0;
  double most = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector away = points[i].at - points[0].at;
    if (dot(away, away) <= most) continue;
    most = dot(away, away);
    farthest = i;
  }
  return farthest;
}

// A closed line's first point is repeated at its end.
std::vector<BeadPoint> simplified(const BeadLine& line, double tolerance) {
  std::vector<BeadPoint> points = line.points;
  if (line.closed) points.push_back(points.front());
  std::vector<std::uint8_t> kept(points.size(), 0);
  const std::size_t last = points.size() - 1,
                    middle = line.closed ? farthest_from_first(points) : 0;
  if (middle > 0) keep_needed(points, 0, middle, tolerance, kept);
  keep_needed(points, middle, last, tolerance, kept);
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i] != 0) points[count++] = points[i];
  }
  points.resize(count);
  return points;
}

}  // namespace

void add_bead_road(const BeadLine& line, const Beading& beading, RoadKind kind, Length tolerance,
                   std::vector<Road>& roads) {
  if (line.points.size() < 2) return;
  Road road{kind, Length(), line.closed, {}};
  double length = 0, area = 0;
  const std::vector<BeadPoint> points = simplified(line, static_cast<double>(tolerance.units()));
  for (const BeadPoint& at : points) {
    const Point point = rounded(at.at);
    if (!road.points.empty() && road.points.back() == point) continue;
    road.points.push_back(point);
    road.widths.push_back(beading.width(at.room));
  }
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vector step = points[i].at - points[i - 1].at;
    const double part = hypotenuse(step.x, step.y);
    length += part;
    area += part * (points[i].room + points[i - 1].room) / 2;
  }
  if (road.closed && road.points.size() > 1 && road.points.back() == road.points.front()) {
    road.points.pop_back();
    road.widths.pop_back();
  }
  if (length <= 0 || road.points.size() < (road.closed ? 3 : 2)) return;
  road.width = beading.width(area / length);
  if (road.closed && length < kLoopWidthsMin * static_cast<double>(road.width.units())) return;
  const auto [least, most] = std::minmax_element(road.widths.begin(), road.widths.end());
  if (*most - *least <= kOneWidth) road.widths.clear();
  roads.push_back(std::move(road));
}

}  // namespace core
