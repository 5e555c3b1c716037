#include "core/offset_contours.h"

#include <algorithm>
#include <cmath>

#include "core/boolean.h"  // clean
#include "core/check.h"    // RIND_CHECK

namespace core {
namespace {

// The arc's points after its first and before its last. Both ends were rounded, so the radius
// goes evenly from the one to the other.
void add_arc(const OffsetPiece& piece, Point to, double tolerance, Ring& ring) {
  const double from_x = static_cast<double>(piece.from.x) - piece.centre.x;
  const double from_y = static_cast<double>(piece.from.y) - piece.centre.y;
  const double to_x = static_cast<double>(to.x) - piece.centre.x;
  const double to_y = static_cast<double>(to.y) - piece.centre.y;
  const double from_radius = std::hypot(from_x, from_y), to_radius = std::hypot(to_x, to_y);
  const double from_angle = std::atan2(from_y, from_x);
  double sweep = std::atan2(to_y, to_x) - from_angle;
  const bool counter_clockwise = piece.kind == OffsetPiece::Kind::kArcCounterClockwise;
  if (counter_clockwise && sweep < 0) sweep += 2 * M_PI;
  if (!counter_clockwise && sweep > 0) sweep -= 2 * M_PI;
  // Two ends so near that rounding turned them round: no arc about a corner exceeds half a turn.
  if (std::abs(sweep) > 1.5 * M_PI) return;
  const double radius = std::max({from_radius, to_radius, 1.0});
  const double step = 2 * std::acos(std::max(0.0, 1 - tolerance / radius));
  const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / step)));
  for (int i = 1; i < chords; ++i) {
    const double part = static_cast<double>(i) / chords;
    const double angle = from_angle + sweep * part;
    const double distance = from_radius + (to_radius - from_radius) * part;
    ring.push_back(
        {static_cast<std::int32_t>(std::lround(piece.centre.x + distance * std::cos(angle))),
         static_cast<std::int32_t>(std::lround(piece.centre.y + distance * std::sin(angle)))});
  }
}

}  // namespace

Region flatten(const OffsetContours& contours, Length tolerance) {
  RIND_CHECK(tolerance > Length());
  std::vector<Ring> rings;
  for (const OffsetContour& contour : contours) {
    Ring ring;
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const OffsetPiece& piece = contour[i];
      ring.push_back(piece.from);
      if (piece.kind == OffsetPiece::Kind::kLine) continue;
      const Point to = contour[i + 1 == contour.size() ? 0 : i + 1].from;
      add_arc(piece, to, static_cast<double>(tolerance.units()), ring);
    }
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() >= 3) rings.push_back(std::move(ring));
  }
  // Rounding can make tiny loops that turn the wrong way: they aren't part of the offset.
  return clean(rings, FillRule::kPositive);
}

}  // namespace core
