#include "host/output/stroke_outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace host {
namespace {

// Pixels; a narrower gap at the outside of a bend needs no disk.
constexpr double kGapMax = 0.15;

struct Direction {
  double x, y;
};

// At the outside of a bend, between the ends of the two pieces.
double gap_at(Direction before, Direction after, double radius) {
  return radius * std::hypot(after.x - before.x, after.y - before.y);
}

Direction direction(Pixel from, Pixel to) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  return {(to.x - from.x) / length, (to.y - from.y) / length};
}

}  // namespace

PixelOutline disk(Pixel middle, double radius) {
  // A side's middle is nearer to the centre by r (1 - cos(pi / n)).
  constexpr double kError = 1.0 / 30;
  const double sides =
      std::numbers::pi / std::acos(1 - std::min(0.5, kError / std::max(radius, kError)));
  const int count = std::max(6, static_cast<int>(std::ceil(sides)));
  PixelOutline outline;
  outline.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    outline.push_back({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)});
  }
  return outline;
}

void append_stroke(const std::vector<Pixel>& all, bool closed, const StrokeForm& form,
                   std::vector<PixelOutline>& outlines) {
  std::vector<Pixel> points;
  for (const Pixel point : all) {
    if (points.empty() || point.x != points.back().x || point.y != points.back().y)
      points.push_back(point);
  }
  if (closed && points.size() > 1 && points.front().x == points.back().x &&
      points.front().y == points.back().y) {
    points.pop_back();
  }
  const double radius = form.width / 2;
  if (points.empty()) return;
  if (points.size() == 1) {
    if (form.round_ends) outlines.push_back(disk(points[0], radius));
    return;
  }
  const std::size_t count = points.size(), pieces = closed ? count : count - 1;
  for (std::size_t i = 0; i < pieces; ++i) {
    const Pixel a = points[i], b = points[(i + 1) % count];
    const Direction along = direction(a, b);
    const double x = -along.y * radius, y = along.x * radius;
    // The same way round as disk().
    outlines.push_back(
        {{a.x - x, a.y - y}, {b.x - x, b.y - y}, {b.x + x, b.y + y}, {a.x + x, a.y + y}});
    const bool ends = !closed && i + 1 == pieces;
    if (ends) continue;
    const Direction next = direction(b, points[(i + 2) % count]);
    if (gap_at(along, next, radius) > kGapMax) outlines.push_back(disk(b, radius));
  }
  if (closed || !form.round_ends) return;
  outlines.push_back(disk(points.front(), radius));
  outlines.push_back(disk(points.back(), radius));
}

}  // namespace host
