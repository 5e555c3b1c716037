#include "core/motions/simplify_pieces.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "core/regions/polyline.h"  // distance_mm, distance_units
#include "core/regions/simplify.h"  // kept_points
#include "core/rounded.h"           // rounded
#include "core/vector.h"            // Vector, to_vector

namespace core {
namespace {

// A point of the simplified run: a point of the run itself, or a corner in place of two of them.
struct Kept {
  Point at;
  std::size_t first = 0;  // points of the run that it stands for: from this one
  std::size_t last = 0;   // to this one
};

// Where a → b, drawn on beyond b, meets d → c, drawn on beyond c. Nothing where they turn by more
// than a right angle: so it is no farther from b and c than these are from one another.
std::optional<Point> corner(Point a, Point b, Point c, Point d) {
  const Vector u = to_vector(b) - to_vector(a), v = to_vector(d) - to_vector(c);
  const Vector gap = to_vector(c) - to_vector(b);
  const double turn = u.x * v.y - u.y * v.x;
  if (turn == 0 || dot(u, v) <= 0) return std::nullopt;
  const double beyond_b = (gap.x * v.y - gap.y * v.x) / turn;
  const double before_c = (gap.y * u.x - gap.x * u.y) / turn;
  if (beyond_b < 0 || before_c < 0) return std::nullopt;
  const Vector at = to_vector(b) + u * beyond_b;
  return rounded(at);
}

// Whether a corner may stand for the run's points from `first` to `last`.
bool stands_for(Point at, const std::vector<Point>& run, std::size_t first, std::size_t last,
                double tolerance) {
  double off = distance_units(at, Segment{run[first], run[first + 1]});
  for (std::size_t i = first + 1; i < last; ++i) {
    off = std::min(off, distance_units(at, Segment{run[i], run[i + 1]}));
    const double left_out = std::min(distance_units(run[i], Segment{run[first], at}),
                                     distance_units(run[i], Segment{at, run[last]}));
    if (left_out > tolerance) return false;
  }
  return off <= tolerance;
}

// The run's points that are kept, two of them as one where a corner may stand for them.
std::vector<Kept> simplified(const std::vector<Point>& run, Length tolerance) {
  const auto reach = static_cast<double>(tolerance.units());
  std::vector<Kept> kept;
  const std::vector<std::size_t> indices = kept_points(run, tolerance);
  kept.reserve(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::size_t first = indices[i];
    if (reach > 0 && i > 0 && i + 2 < indices.size()) {
      const std::size_t last = indices[i + 1];
      const Point before = kept.back().at, after = run[indices[i + 2]];
      const double way = distance_units(run[first], run[last]);
      const bool shorter =
          way < distance_units(before, run[first]) && way < distance_units(run[last], after);
      const auto at = shorter ? corner(before, run[first], run[last], after) : std::nullopt;
      if (at && stands_for(*at, run, first, last, reach)) {
        kept.push_back({*at, first, last});
        ++i;
        continue;
      }
    }
    kept.push_back({run[first], first, first});
  }
  return kept;
}

// How much of the way that a corner stands for lies before it, as a share.
double share_before(const Kept& corner, const std::vector<Point>& run) {
  const double before = distance_units(run[corner.first], corner.at);
  const double way = before + distance_units(corner.at, run[corner.last]);
  return way > 0 ? before / way : 0;
}

// What the pieces from point `first` to point `last` of a run are laid over, in mm.
double laid_over_mm(const RoadPiece* pieces, std::size_t first, std::size_t last) {
  double sum = 0;
  for (std::size_t i = first; i < last; ++i) sum += pieces[i].laid_over_mm;
  return sum;
}

}  // namespace

void simplify_pieces(Point from, std::vector<RoadPiece>& pieces, Length tolerance) {
  std::vector<Point> run;
  std::vector<RoadPiece> simpler;
  std::size_t done = 0;
  for (std::size_t first = 0; first < pieces.size();) {
    if (pieces[first].is_arc) {
      from = pieces[first].to;
      pieces[done++] = pieces[first++];
      continue;
    }
    std::size_t end = first + 1;
    if (end == pieces.size() || pieces[end].is_arc) {
      RoadPiece alone = pieces[first];
      alone.length_mm = distance_mm(from, alone.to);
      from = alone.to;
      pieces[done++] = alone;
      first = end;
      continue;
    }
    run.assign({from, pieces[first].to});
    for (; end < pieces.size() && !pieces[end].is_arc; ++end) run.push_back(pieces[end].to);
    simpler.clear();
    const std::vector<Kept> kept = simplified(run, tolerance);
    double carried = 0;  // what a corner stands for is laid before it and behind it
    for (std::size_t i = 1; i < kept.size(); ++i) {
      RoadPiece piece;
      piece.to = kept[i].at;
      piece.length_mm = distance_mm(from, piece.to);
      const double round = laid_over_mm(&pieces[first], kept[i].first, kept[i].last);
      const double before = round * share_before(kept[i], run);
      piece.laid_over_mm =
          carried + laid_over_mm(&pieces[first], kept[i - 1].last, kept[i].first) + before;
      carried = round - before;
      from = piece.to;
      simpler.push_back(piece);
    }
    for (const RoadPiece& piece : simpler) pieces[done++] = piece;
    first = end;
  }
  pieces.resize(done);
}

}  // namespace core
