#include "core/motions/road_pieces.h"

#include <algorithm>

#include "core/motions/segment_merger.h"   // merge_short_pieces, sendable_speed
#include "core/motions/simplify_pieces.h"  // simplify_pieces
#include "core/regions/polyline.h"         // distance_mm

namespace core {

const std::vector<RoadPiece>& RoadPieces::of(const WidthStretch& stretch, bool arcs,
                                             double& speed_mm_s) {
  const Point start = stretch.points.front();
  if (stretch.points.size() <= 2) {
    pieces_.clear();
    if (start == stretch.points.back()) return pieces_;
    RoadPiece& piece = pieces_.emplace_back();
    piece.to = stretch.points.back();
    piece.length_mm = piece.laid_over_mm = distance_mm(start, piece.to);
    return pieces_;
  }
  pieces_ = (arcs ? fitter_ : segments_).pieces(stretch.points, stretch.closed);
  simplify_pieces(start, pieces_, settings_.segment_tolerance);
  const double time_min_s = settings_.segment_time_min_ms / 1'000;
  if (time_min_s <= 0) return pieces_;
  merge_short_pieces(start, pieces_, speed_mm_s * time_min_s, settings_.segment_tolerance.mm());
  // However dense a spot is, it is no reason to stand on the part.
  const double slowest = std::min(speed_mm_s, settings_.slowed_speed_min_mm_s);
  speed_mm_s = std::max(slowest, sendable_speed(pieces_, speed_mm_s, time_min_s));
  return pieces_;
}

}  // namespace core
