#include "core/motions/segment_merger.h"

#include <algorithm>
#include <cmath>

#include "core/regions/polyline.h"  // distance_mm, distance_units

namespace core {
namespace {

// How many pieces from `first` on one straight piece can stand for.
std::size_t mergeable(Point from, const std::vector<RoadPiece>& pieces, std::size_t first,
                      double length_min_mm, double tolerance_mm) {
  std::size_t count = 1;
  double way_mm = pieces[first].length_mm;
  while (first + count < pieces.size() && way_mm < length_min_mm) {
    const RoadPiece& next = pieces[first + count];
    if (next.is_arc || next.length_mm >= length_min_mm || next.to == from) break;
    const auto near = [&](const RoadPiece& piece) {
      return distance_units(piece.to, Segment{from, next.to}) / kUnitsPerMm <= tolerance_mm;
    };
    const auto begin = pieces.begin() + static_cast<std::ptrdiff_t>(first);
    if (!std::all_of(begin, begin + static_cast<std::ptrdiff_t>(count), near)) break;
    way_mm += next.length_mm;
    ++count;
  }
  return count;
}

}  // namespace

void merge_short_pieces(Point from, std::vector<RoadPiece>& pieces, double length_min_mm,
                        double tolerance_mm) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pieces.size();) {
    RoadPiece piece = pieces[i];
    std::size_t count = 1;
    if (!piece.is_arc) count = mergeable(from, pieces, i, length_min_mm, tolerance_mm);
    if (count > 1) {
      piece.laid_over_mm = 0;
      for (std::size_t k = 0; k < count; ++k) piece.laid_over_mm += pieces[i + k].laid_over_mm;
      piece.to = pieces[i + count - 1].to;
      piece.length_mm = distance_mm(from, piece.to);
    }
    i += count;
    from = piece.to;
    pieces[kept++] = piece;
  }
  pieces.resize(kept);
}

double sendable_speed(const std::vector<RoadPiece>& pieces, double speed_mm_s, double time_min_s) {
  double speed = speed_mm_s;
  double length_mm = 0;
  std::size_t lines = 0;
  std::size_t first = 0;
  const auto lines_of = [](const RoadPiece& piece) { return piece.is_arc ? kArcLines : 1; };
  for (const RoadPiece& piece : pieces) {
    length_mm += piece.length_mm;
    lines += lines_of(piece);
    if (lines < kSegmentWindow) continue;
    speed = std::min(speed, length_mm / (static_cast<double>(lines) * time_min_s));
    while (lines >= kSegmentWindow) {
      length_mm -= pieces[first].length_mm;
      lines -= lines_of(pieces[first++]);
    }
  }
  return speed;
}

}  // namespace core
