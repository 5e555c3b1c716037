#include "core/offsets/offset_contours.h"

#include <algorithm>
#include <cmath>

#include "core/booleans/boolean.h"       // clean
#include "core/check.h"                  // RIND_CHECK
#include "core/regions/contact_check.h"  // surely_clean
#include "core/rounded.h"                // rounded
#include "core/trigonometry.h"           // arc_tangent, arc_cosine, cosine, sine

namespace core {
namespace {

// The arc's points after its first and before its last. Both ends were rounded, so the radius
// goes evenly from the one to the other.
void add_arc(const OffsetPiece& piece, Point to, double tolerance, Ring& ring) {
  const double from_x = static_cast<double>(piece.from.x) - piece.centre.x;
  const double from_y = static_cast<double>(piece.from.y) - piece.centre.y;
  const double to_x = static_cast<double>(to.x) - piece.centre.x;
  const double to_y = static_cast<double>(to.y) - piece.centre.y;
  const double side = piece.kind == OffsetPiece::Kind::kArcCounterClockwise ? 1 : -1;
  const double along = from_x * to_x + from_y * to_y;
  const double across = side * (from_x * to_y - from_y * to_x);
  const double from_squared = from_x * from_x + from_y * from_y;
  const double to_squared = to_x * to_x + to_y * to_y;
  const double squared = std::max({from_squared, to_squared, 1.0}), radius = std::sqrt(squared);
  const double half_cosine = std::max(0.0, 1 - tolerance / radius);
  // Most arcs are one chord, which their cosine tells.
  if (across >= 0 && along >= (2 * half_cosine * half_cosine - 1) * squared) return;
  double sweep = arc_tangent(across, along);
  if (sweep < 0) sweep += 2 * M_PI;
  // Two ends so near that rounding turned them round: no arc about a corner exceeds half a turn.
  if (sweep > 1.5 * M_PI) return;
  const int chords =
      std::max(1, static_cast<int>(std::ceil(sweep / (2 * arc_cosine(half_cosine)))));
  const double growth = std::sqrt(to_squared / std::max(from_squared, 1.0)) - 1;
  const double cosine = core::cosine(sweep / chords), sine = side * core::sine(sweep / chords);
  double x = from_x, y = from_y;
  for (int i = 1; i < chords; ++i) {
    const double turned = x * cosine - y * sine;
    y = x * sine + y * cosine;
    x = turned;
    const double stretch = 1 + growth * i / chords;
    ring.push_back({rounded(piece.centre.x + x * stretch), rounded(piece.centre.y + y * stretch)});
  }
}

}  // namespace

Region flatten(const OffsetContours& contours, Length tolerance) {
  RIND_CHECK(tolerance > Length());
  thread_local Ring ring;  // kept, so that a result's ring is allocated once
  std::vector<Ring> rings;
  rings.reserve(contours.size());
  for (const OffsetContour& contour : contours) {
    ring.clear();
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const OffsetPiece& piece = contour[i];
      ring.push_back(piece.from);
      if (piece.kind == OffsetPiece::Kind::kLine) continue;
      const Point to = contour[i + 1 == contour.size() ? 0 : i + 1].from;
      add_arc(piece, to, static_cast<double>(tolerance.units()), ring);
    }
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() >= 3) rings.emplace_back(ring.begin(), ring.end());
  }
  // Rounding can make tiny loops that turn the wrong way: they aren't part of the offset.
  if (surely_clean(rings)) return Region::from_clean_rings(std::move(rings));
  return clean(rings, FillRule::kPositive);
}

}  // namespace core
