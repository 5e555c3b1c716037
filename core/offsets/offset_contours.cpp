#include "core/offsets/offset_contours.h"

#include <algorithm>

#include "core/booleans/boolean.h"       // clean
#include "core/check.h"                  // RIND_CHECK
#include "core/offsets/arc_polygon.h"    // ArcPolygon
#include "core/regions/contact_check.h"  // surely_clean

namespace core {
namespace {

Arc arc_of(const OffsetPiece& piece, Point end) {
  const Vector centre = to_vector(piece.centre);
  return {centre, to_vector(piece.from) - centre, to_vector(end) - centre,
          piece.kind == OffsetPiece::Kind::kArcCounterClockwise ? 1.0 : -1.0};
}

void flatten(const OffsetContour& contour, ArcForm form, ArcPolygon& polygon, Ring& ring) {
  const std::size_t count = contour.size();
  const auto at = [&](std::size_t i) -> const OffsetPiece& {
    return contour[i < count ? i : i - count];
  };
  const auto is_line = [&](std::size_t i) { return at(i).kind == OffsetPiece::Kind::kLine; };
  bool start_replaced = false;  // the piece's own start, by what stands for the arc before it
  for (std::size_t i = 0; i < count; ++i) {
    if (is_line(i)) {
      if (!start_replaced) ring.push_back(at(i).from);
      start_replaced = false;
      continue;
    }
    const Arc arc = arc_of(at(i), at(i + 1).from);
    if (form == ArcForm::kBothSides && is_line(i + 1) && is_line(i + count - 1)) {
      const Point before = ring.empty() ? at(i + count - 1).from : ring.back();
      start_replaced = polygon.add_between(before, arc, at(i + 2).from, ring);
      if (start_replaced) continue;
    }
    ring.push_back(at(i).from);
    polygon.add_chords(arc, ring);
  }
  if (start_replaced) ring.erase(ring.begin());  // contour[0] is the line after the last arc
}

}  // namespace

Region flatten(const OffsetContours& contours, Length tolerance, ArcForm form) {
  RIND_CHECK(tolerance > Length());
  thread_local Ring ring;  // kept, so that a result's ring is allocated once
  ArcPolygon polygon(static_cast<double>(tolerance.units()));
  std::vector<Ring> rings;
  rings.reserve(contours.size());
  for (const OffsetContour& contour : contours) {
    ring.clear();
    flatten(contour, form, polygon, ring);
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() >= 3) rings.emplace_back(ring.begin(), ring.end());
  }
  // Rounding can make tiny loops that turn the wrong way: they aren't part of the offset.
  if (surely_clean(rings)) return Region::from_clean_rings(std::move(rings));
  return clean(rings, FillRule::kPositive);
}

}  // namespace core
