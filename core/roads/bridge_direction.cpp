#include "core/roads/bridge_direction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "core/roads/row_cuts.h"  // even_rows_over
#include "core/trigonometry.h"    // arc_tangent, cosine, hypotenuse, sine

namespace core {
namespace {

// Directions are measured with this many rows at most.
constexpr double kTrialRows = 24;

// Edges that differ by less are of one direction.
constexpr std::size_t kDirectionSteps = 180;  // of 1°

// A millimetre held on one side only counts as the square of a span of 10 mm.
constexpr double kOneSidedCost_mm = 100;

// Edges by their direction, which has no sense.
class DirectionVotes {
 public:
  explicit DirectionVotes(const Region& region) {
    for (const Segment& edge : edges_of(region.rings())) {
      const Vector way = to_vector(edge.to) - to_vector(edge.from);
      const double length = hypotenuse(way.x, way.y);
      if (length == 0) continue;
      const double turns = arc_tangent(way.y, way.x) / std::numbers::pi + 1;  // 0 … 2
      const auto step =
          static_cast<std::size_t>(std::lround(turns * kDirectionSteps)) % kDirectionSteps;
      Vote& vote = votes_[step];
      vote.length += length;
      if (length <= vote.longest) continue;
      vote.longest = length;
      vote.direction = way * (1 / length);
    }
  }

  // The most common first, each with the one across it; then the fixed ones.
  [[nodiscard]] std::vector<Vector> directions(const DirectionTrials& trials) {
    std::vector<Vector> all;
    std::stable_sort(votes_.begin(), votes_.end(),
                     [](const Vote& a, const Vote& b) { return a.length > b.length; });
    for (int i = 0; i < trials.edges; ++i) {
      const Vote& vote = votes_[static_cast<std::size_t>(i)];
      if (vote.length == 0) break;
      all.push_back(vote.direction);
      all.push_back(left_of(vote.direction));
    }
    for (int i = 0; i < trials.fixed; ++i) {
      const double angle = i * std::numbers::pi / trials.fixed;
      all.push_back({cosine(angle), sine(angle)});
    }
    return all;
  }

 private:
  struct Vote {
    double length = 0;
    double longest = 0;
    Vector direction;
  };
  std::array<Vote, kDirectionSteps> votes_;
};

double cost(const BridgeRows& rows) {
  return rows.cut_spans_mm * kOneSidedCost_mm + rows.laid_squares_mm2;
}

}  // namespace

Vector best_direction(const BridgeArea& area, Length distance, const DirectionTrials& trials) {
  Vector best{1, 0};
  double least = std::numeric_limits<double>::max();
  for (const Vector direction : DirectionVotes(area.region).directions(trials)) {
    const RowGrid all =
        even_rows_over(area.region, direction, static_cast<double>(distance.units()));
    const double thinned = std::max(1.0, static_cast<double>(all.count) / kTrialRows);
    const BridgeRows rows = bridge_rows(area, direction, Length::from_mm(distance.mm() * thinned));
    // By the rows' number: the cost of all, not of those that are measured.
    const double here = cost(rows) * rows.grid.distance;
    if (here >= least) continue;
    least = here;
    best = direction;
  }
  return best;
}

}  // namespace core
