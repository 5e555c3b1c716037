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

void add_piece(Point a, Point b, double half, std::vector<Ring>& outlines) {
  const double dx = static_cast<double>(b.x) - a.x, dy = static_cast<double>(b.y) - a.y;
  const double length = std::hypot(dx, dy);
  if (length == 0) return;
  const double nx = -dy / length * half, ny = dx / length * half;
  outlines.push_back({rounded(a.x - nx, a.y - ny), rounded(b.x - nx, b.y - ny),
                      rounded(b.x + nx, b.y + ny), rounded(a.x + nx, a.y + ny)});
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

bool turns(Point a, Point b, Point c) {
  const double ux = static_cast<double>(b.x) - a.x, uy = static_cast<double>(b.y) - a.y;
  const double vx = static_cast<double>(c.x) - b.x, vy = static_cast<double>(c.y) - b.y;
  return ux * vx + uy * vy < kTurnCosine * std::hypot(ux, uy) * std::hypot(vx, vy);
}

}  // namespace

void add_bead_outlines(const Road& road, Length width, std::vector<Ring>& outlines) {
  const double half = static_cast<double>(width.units()) / 2;
  const std::vector<Point>& points = road.points;
  const std::size_t count = points.size();
  const std::size_t pieces = road.closed ? count : count - 1;
  for (std::size_t i = 0; i < pieces; ++i) {
    const Point a = points[i], b = points[(i + 1) % count];
    add_piece(a, b, half, outlines);
    const bool last = i + 1 == pieces;
    if ((!last || road.closed) && turns(a, b, points[(i + 2) % count])) {
      add_octagon(b, half, outlines);
    }
  }
}

Region bead_cover(const std::vector<Road>& roads, Length width) {
  std::vector<Ring> outlines;
  for (const Road& road : roads) add_bead_outlines(road, width, outlines);
  return clean(outlines, FillRule::kNonZero);
}

}  // namespace core
