#include "core/motions/simplify_pieces.h"

#include <cstddef>

#include "core/regions/polyline.h"  // distance_mm
#include "core/regions/simplify.h"  // kept_points

namespace core {

void simplify_pieces(Point from, std::vector<RoadPiece>& pieces, Length tolerance) {
  std::vector<Point> run;
  std::size_t kept = 0;
  for (std::size_t first = 0; first < pieces.size();) {
    if (pieces[first].is_arc) {
      from = pieces[first].to;
      pieces[kept++] = pieces[first++];
      continue;
    }
    run.assign(1, from);
    std::size_t end = first;
    for (; end < pieces.size() && !pieces[end].is_arc; ++end) run.push_back(pieces[end].to);
    std::size_t at = first;
    for (const std::size_t index : kept_points(run, tolerance)) {
      if (index == 0) continue;
      RoadPiece piece = pieces[first + index - 1];
      double laid_over_mm = 0;
      for (; at < first + index; ++at) laid_over_mm += pieces[at].laid_over_mm;
      piece.laid_over_mm = laid_over_mm;
      piece.length_mm = distance_mm(from, piece.to);
      from = piece.to;
      pieces[kept++] = piece;
    }
    first = end;
  }
  pieces.resize(kept);
}

}  // namespace core
