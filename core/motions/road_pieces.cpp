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
  simplify_pieces(start, pieces_, tolerance_);
  if (time_min_s_ <= 0) return pieces_;
  merge_short_pieces(start, pieces_, speed_mm_s * time_min_s_, tolerance_.mm());
  // However dense a spot is, it is no reason to stand on the part.
  const double slowest = std::min(speed_mm_s, slowest_mm_s_);
  speed_mm_s = std::max(slowest, sendable_speed(pieces_, speed_mm_s, time_min_s_));
  return pieces_;
}

}  // namespace core
