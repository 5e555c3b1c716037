#include "core/bead_cover.h"

#include <cmath>
#include <numbers>

#include "core/boolean.h"   // clean
#include "core/polyline.h"  // distance_mm

namespace core {

namespace {

// Turns sharper than this (about 18°) leave a wedge between two rectangles worth closing.
constexpr double kTurnCosine = 0.95;

Point rounded(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y))};
}

struct Direction {
  double x = 0;
  double y = 0;
};

Direction direction(Point a, Point b) {
  const double dx = static_cast<double>(b.x) - a.x, dy = static_cast<double>(b.y) - a.y;
  const double length = std::hypot(dx, dy);
  return length > 0 ? Direction{dx / length, dy / length} : Direction{1, 0};
}

bool sharp(Direction in, Direction out) { return in.x * out.x + in.y * out.y < kTurnCosine; }

// What to go sideways at a point where a road comes in and goes out. Both pieces use it, so that
// their outlines share their corners to the unit.
Direction sideways(Direction in, Direction out, double half) {
  const double share = half / (1 + in.x * out.x + in.y * out.y);
  return {-(in.y + out.y) * share, (in.x + out.x) * share};
}

// Its sides, not its corners, touch the circle.
void add_octagon(Point centre, double half, std::vector<Ring>& outlines) {
  Ring ring;
  const double reach = half / std::cos(std::numbers::pi / 8);
  for (int i = 0; i < 8; ++i) {
    const double angle = (i + 0.5) * std::numbers::pi / 4;
    ring.push_back(rounded(centre.x + reach * std::cos(angle), centre.y + reach * std::sin(angle)));
  }
  outlines.push_back(std::move(ring));
}

}  // namespace

void add_bead_outlines(const Road& road, Length width, std::vector<Ring>& outlines) {
  const double half = static_cast<double>(width.units()) / 2;
  const std::vector<Point>& points = road.points;
  const std::size_t count = points.size();
  const std::size_t pieces = road.closed ? count : count - 1;
  for (std::size_t i = 0; i < pieces; ++i) {
    const Point a = points[i], b = points[(i + 1) % count];
    if (a == b) continue;
    const Direction along = direction(a, b);
    Direction in = along, out = along;
    if (i > 0 || road.closed) in = direction(points[(i + count - 1) % count], a);
    if (i + 1 < pieces || road.closed) out = direction(b, points[(i + 2) % count]);
    if (sharp(along, out)) add_octagon(b, half, outlines);
    const Direction at_a = sideways(sharp(in, along) ? along : in, along, half);
    const Direction at_b = sideways(along, sharp(along, out) ? along : out, half);
    outlines.push_back({rounded(a.x - at_a.x, a.y - at_a.y), rounded(b.x - at_b.x, b.y - at_b.y),
                        rounded(b.x + at_b.x, b.y + at_b.y), rounded(a.x + at_a.x, a.y + at_a.y)});
  }
}

Region bead_cover(const std::vector<Road>& roads, Length width) {
  std::vector<Ring> outlines;
  for (const Road& road : roads) add_bead_outlines(road, width, outlines);
  return clean(outlines, FillRule::kNonZero);
}

}  // namespace core
