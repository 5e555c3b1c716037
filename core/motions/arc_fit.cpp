#include "core/motions/arc_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/check.h"         // RIND_CHECK
#include "core/trigonometry.h"  // arc_tangent, hypotenuse

namespace core {
namespace {

// The centre lies on the grid: half a unit's diagonal, at either end of a radius.
constexpr double kRounding = 1.5;
constexpr double kRadiusMin = kArcRadiusMin_mm * kUnitsPerMm;
constexpr double kRadiusMax = kArcRadiusMax_mm * kUnitsPerMm;
constexpr double kLengthMin = kArcLengthMin_mm * kUnitsPerMm;
constexpr double kSweepMax = kArcSweepMax_degrees / 180 * std::numbers::pi;
// An arc that rises less over its chord than this many tolerances is as good as straight.
constexpr double kHeightMin_tolerances = 2;

}  // namespace

ArcFitter::ArcFitter(Length tolerance)
    : tolerance_(static_cast<double>(tolerance.units()) - kRounding) {
  RIND_CHECK(tolerance.units() >= 0);
}

const std::vector<RoadPiece>& ArcFitter::pieces(const std::vector<Point>& points, bool closed) {
  take(points, closed);
  find_runs();
  pieces_.clear();
  if (backwards_) std::reverse(runs_.begin(), runs_.end());
  for (const Run& run : runs_) {
    if (run.is_arc) {
      pieces_.push_back(piece(run));
      continue;
    }
    for (std::size_t i = run.first; i < run.last; ++i) {
      const std::size_t at = backwards_ ? run.last - 1 - (i - run.first) : i;
      pieces_.push_back(piece({at, at + 1, {}, false}));
    }
  }
  return pieces_;
}

// In the direction that both ways round have in common.
void ArcFitter::take(const std::vector<Point>& points, bool closed) {
  const bool ring = closed || points.front() == points.back();
  const std::size_t back = closed ? points.size() - 1 : points.size() - 2;
  backwards_ = ring ? points[back] < points[1] : points.back() < points.front();
  nodes_.clear();
  const auto add = [this](Point point) {
    if (!nodes_.empty() && nodes_.back().point == point) return;
    Node node;
    node.point = point;
    if (!nodes_.empty()) {
      const Node& before = nodes_.back();
      node.x = static_cast<double>(point.x) - nodes_.front().point.x;
      node.y = static_cast<double>(point.y) - nodes_.front().point.y;
      node.way = before.way + hypotenuse(node.x - before.x, node.y - before.y);
    }
    nodes_.push_back(node);
  };
  if (backwards_) {
    if (closed) add(points.front());
    for (std::size_t i = points.size(); i-- > 0;) add(points[i]);
  } else {
    for (const Point& point : points) add(point);
    if (closed) add(points.front());
  }
}

// Where the longest run is as good as straight, its second half may be the start of a round one.
void ArcFitter::find_runs() {
  runs_.clear();
  std::size_t first = 0;
  while (first + 1 < nodes_.size()) {
    Run run = longest_run(first);
    if (!run.is_arc) {
      const bool joins = !runs_.empty() && !runs_.back().is_arc;
      if (joins) {
        runs_.back().last = run.last;
      } else {
        runs_.push_back(run);
      }
    } else {
      runs_.push_back(run);
    }
    first = run.last;
  }
}

ArcFitter::Run ArcFitter::longest_run(std::size_t first) const {
  const std::size_t left = nodes_.size() - 1 - first;
  Run run{first, first + 1, {}, false};
  std::size_t good = 0, bad = left + 1;
  Arc arc;
  for (std::size_t size = kArcSegmentsMin; size < bad;) {
    if (fits(first, first + size, arc)) {
      good = size;
      run.arc = arc;
      size = bad > left ? std::min(2 * size, left) : (good + bad) / 2;
      if (size == good) break;
    } else {
      bad = size;
      if (good == 0) break;
      size = (good + bad) / 2;
      if (size == good) break;
    }
  }
  if (good == 0) return run;
  run.is_arc = run.arc.length >= kLengthMin && run.arc.height >= kHeightMin_tolerances * tolerance_;
  run.last = first + (run.is_arc ? good : std::max<std::size_t>(1, good / 2));
  return run;
}

//            h    m    h            c = m + t · n,  r² = h² + t²
//      first o────┼────o last       (u, v): a point from m, along the chord and n
//             ╲   │   ╱
//            r ╲  │t ╱ r            u² + v² − h² − 2 v t = 2 r δ + δ²,  δ its distance from the
//               ╲ │ ╱               circle: t = Σ v (u² + v² − h²) / 2 Σ v² for the least Σ δ²
//                 c
bool ArcFitter::fits(std::size_t first, std::size_t last, Arc& arc) const {
  const Node& a = nodes_[first];
  const Node& b = nodes_[last];
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double chord = hypotenuse(dx, dy);
  if (chord == 0) return false;
  const double half = chord / 2;
  const double nx = -dy / chord, ny = dx / chord;
  const double mx = (a.x + b.x) / 2, my = (a.y + b.y) / 2;
  double vq = 0, vv = 0, side = 0;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double x = nodes_[i].x - mx, y = nodes_[i].y - my;
    const double v = x * nx + y * ny;
    vq += v * (x * x + y * y - half * half);
    vv += v * v;
    side += v;
  }
  if (vv == 0 || side == 0) return false;
  const double t = vq / (2 * vv);
  if (!(std::abs(t) < kRadiusMax)) return false;
  const double cx = std::round(mx + t * nx), cy = std::round(my + t * ny);
  const double radius = hypotenuse(a.x - cx, a.y - cy);
  const double way = b.way - a.way;
  if (radius < kRadiusMin || radius > kRadiusMax || way > kSweepMax * radius) return false;
  // A run that bulges to the left turns to the right.
  arc.clockwise = side > 0;
  if (!near_circle(first, last, cx, cy, radius, arc.clockwise ? -1 : 1)) return false;
  const double beyond = arc.clockwise ? t : -t;  // of the centre, to the bulge's side
  const double sweep = 2 * arc_tangent(half, -beyond);
  if (sweep > kSweepMax) return false;
  const Point origin = nodes_.front().point;
  const double centre_x = cx + origin.x, centre_y = cy + origin.y;
  constexpr double kMost = 2e9;
  if (std::abs(centre_x) > kMost || std::abs(centre_y) > kMost) return false;
  arc.centre = {static_cast<std::int32_t>(centre_x), static_cast<std::int32_t>(centre_y)};
  arc.length = sweep * radius;
  arc.height = radius + beyond;
  return true;
}

// Whether all points are near the circle, in the order of their angles, and no segment cuts it too
// deep. `side`: 1 where the way goes counter-clockwise.
bool ArcFitter::near_circle(std::size_t first, std::size_t last, double x, double y, double radius,
                            double side) const {
  const double outer = radius + tolerance_, inner = radius - tolerance_;
  if (tolerance_ <= 0 || inner <= 0) return false;
  double px = nodes_[first].x - x, py = nodes_[first].y - y;
  for (std::size_t i = first + 1; i <= last; ++i) {
    const double qx = nodes_[i].x - x, qy = nodes_[i].y - y;
    const double squared = qx * qx + qy * qy;
    if (squared > outer * outer || squared < inner * inner) return false;
    const double turned = (px * qy - py * qx) * side;
    const double sx = qx - px, sy = qy - py;
    if (turned <= 0 || px * qx + py * qy <= 0) return false;
    const double size = nodes_[i].way - nodes_[i - 1].way;
    const double foot = -(px * sx + py * sy);
    const bool foot_within = foot > 0 && foot < size * size;
    if (foot_within && turned < inner * size) return false;
    px = qx;
    py = qy;
  }
  return true;
}

RoadPiece ArcFitter::piece(const Run& run) const {
  RoadPiece piece;
  piece.to = nodes_[backwards_ ? run.first : run.last].point;
  piece.laid_over_mm = (nodes_[run.last].way - nodes_[run.first].way) / kUnitsPerMm;
  piece.is_arc = run.is_arc;
  piece.length_mm = run.is_arc ? run.arc.length / kUnitsPerMm : piece.laid_over_mm;
  if (run.is_arc) {
    piece.centre = run.arc.centre;
    piece.clockwise = run.arc.clockwise != backwards_;
  }
  return piece;
}

}  // namespace core
