#include "core/roads/seam_loops.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "core/limits.h"                  // kSeamCornersMax
#include "core/regions/corner_index.h"    // CornerIndex
#include "core/regions/point_location.h"  // PointLocation
#include "core/regions/polyline.h"        // between, distance_units, length_mm
#include "core/regions/segment_grid.h"    // SegmentGrid
#include "core/vector.h"                  // Vector, share_along, to_vector

namespace core {

namespace {

// A turn of 80° is as good as any sharper one.
constexpr double kFullTurn = 1.4;
constexpr double kHollowMerit = 0.7;
constexpr double kJuttingMerit = 0.3;

using CornersAbove = std::vector<std::shared_ptr<const CornerIndex>>;

// In the mean over the layer and those above it.
double lasting_merit(const RingCorner& corner, const CornersAbove& above) {
  double sum = seam_merit(corner.turn);
  CornerIndex::Corner at{corner.place.at, corner.turn};
  for (const auto& corners : above) {
    if (!corners) break;
    const auto next = corners->nearest(at.at, at.turn, kSeamFollow);
    if (!next) break;
    sum += seam_merit(next->turn);
    at = *next;
  }
  return sum / static_cast<double>(1 + above.size());
}

// The best kSeamCornersMax, in their order along the road.
std::vector<SeamPlace> best_corners(const Road& road, const SeamLoop& loop,
                                    const CornersAbove& above) {
  std::vector<SeamPlace> places;
  for (const RingCorner& corner : ring_corners(road.points, kCornerArm)) {
    if (!is_held(loop, road, corner.place)) continue;
    places.push_back({corner.place, lasting_merit(corner, above)});
  }
  if (places.size() <= kSeamCornersMax) return places;
  const auto worst = places.begin() + static_cast<std::ptrdiff_t>(kSeamCornersMax);
  std::stable_sort(places.begin(), places.end(),
                   [](const SeamPlace& a, const SeamPlace& b) { return a.merit > b.merit; });
  places.erase(worst, places.end());
  std::sort(places.begin(), places.end(),
            [](const SeamPlace& a, const SeamPlace& b) { return a.place.edge < b.place.edge; });
  return places;
}

// What of a contour the slice below holds.
class Below {
 public:
  explicit Below(const Region& region) : inside_(region), contours_(kHeldStep, region) {}

  void mark(const std::vector<Point>& points, SeamLoop& loop) const {
    std::size_t held = 0, whole = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point next = points[i + 1 < points.size() ? i + 1 : 0];
      loop.held_points.push_back(holds(points[i]));
      loop.held_edges.push_back(loop.held_points[i] && !contours_.crosses({points[i], next}));
      held += loop.held_points[i] ? 1 : 0;
      whole += loop.held_edges[i] ? 1 : 0;
    }
    if (held == 0) mark_between(points, loop);
    if (whole < points.size() && (held > 0 || !loop.held_between.empty())) return;
    loop.held_points.clear();
    loop.held_edges.clear();
  }

 private:
  // A road that starts just at the edge of what holds it ends there in the air.
  [[nodiscard]] bool holds(Point at) const {
    return inside_.contains(at) && !contours_.any_within(at, kHeldMargin);
  }

  // Places of edges that come into the region and leave it, at most kHeldStep apart.
  void mark_between(const std::vector<Point>& points, SeamLoop& loop) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point next = points[i + 1 < points.size() ? i + 1 : 0];
      if (!contours_.crosses({points[i], next})) continue;
      const auto steps =
          static_cast<std::size_t>(std::ceil(distance_mm(points[i], next) / kHeldStep.mm()));
      for (std::size_t step = 1; step < steps; ++step) {
        const double share = static_cast<double>(step) / static_cast<double>(steps);
        const RingPlace place{between(points[i], next, share), i};
        if (holds(place.at)) loop.held_between.push_back(place);
      }
    }
  }

  static constexpr Length kHeldStep = Length::from_units(5'000);
  static constexpr Length kHeldMargin = Length::from_units(1'000);

  PointLocation inside_;
  SegmentGrid contours_;
};

bool is_outer(const Road& road) {
  return road.closed &&
         (road.kind == RoadKind::kOuterPerimeter || road.kind == RoadKind::kOverhangPerimeter);
}

// The outer loop that is nearest to each inner one.
void add_followers(const LayerRoads& roads, LayerSeams& seams) {
  std::vector<Segment> edges;
  std::vector<std::size_t> loop_of;  // by edge
  for (std::size_t i = 0; i < seams.loops.size(); ++i) {
    const SeamLoop& loop = seams.loops[i];
    for (const Segment& edge : edges_of({roads.islands[loop.island][loop.road].points})) {
      edges.push_back(edge);
      loop_of.push_back(i);
    }
  }
  if (edges.empty()) return;
  const SegmentGrid grid(Length::from_mm(1), edges);
  std::vector<std::uint32_t> near;
  for (std::size_t island = 0; island < roads.islands.size(); ++island) {
    for (std::size_t i = 0; i < roads.islands[island].size(); ++i) {
      const Road& road = roads.islands[island][i];
      if (!road.closed || road.kind != RoadKind::kPerimeter) continue;
      // Perimeters are counted, so no inner one is farther than a few roads.
      const Point at = road.points.front();
      std::optional<std::size_t> nearest;
      double nearest_units = 0;
      for (std::int64_t reach = road.width.units() * 2;
           !nearest && reach <= road.width.units() * 64; reach *= 4) {
        const auto r = static_cast<std::int32_t>(reach);
        near.clear();
        grid.collect({{at.x - r, at.y - r}, {at.x + r, at.y + r}}, near);
        for (const std::uint32_t number : near) {
          const auto& [from, to] = edges[number];
          const Vector along = to_vector(to) - to_vector(from);
          const double share = share_along(to_vector(at) - to_vector(from), along);
          const double away_units = distance_units(at, between(from, to, share));
          if (nearest && away_units >= nearest_units) continue;
          nearest = loop_of[number];
          nearest_units = away_units;
        }
      }
      if (nearest) seams.followers.push_back({island, i, *nearest});
    }
  }
}

}  // namespace

double seam_merit(double turn) {
  const double size = std::abs(turn);
  if (size < kCornerTurnMin) return 0;
  const double share = std::min(1.0, (size - kCornerTurnMin) / (kFullTurn - kCornerTurnMin));
  return turn < 0 ? kHollowMerit + (1 - kHollowMerit) * share : kJuttingMerit * share;
}

bool is_held(const SeamLoop& loop, const Road& road, RingPlace place) {
  if (loop.held_points.empty()) return true;
  const bool point = place.at == road.points[place.edge];
  return point ? loop.held_points[place.edge] : loop.held_edges[place.edge];
}

LayerSeams seam_loops(const SplitLayer& layer, const LayerRoads& roads) {
  LayerSeams seams;
  std::optional<Below> below;
  if (layer.below && !(*layer.below == layer.slice.region)) below.emplace(*layer.below);
  for (std::size_t island = 0; island < roads.islands.size(); ++island) {
    for (std::size_t i = 0; i < roads.islands[island].size(); ++i) {
      const Road& road = roads.islands[island][i];
      if (!is_outer(road)) continue;
      SeamLoop loop{island, i, doubled_area_units(road.points) < 0, box_of(road.points)};
      loop.length_mm = length_mm(road);
      if (below) below->mark(road.points, loop);
      loop.corners = best_corners(road, loop, layer.corners_above);
      seams.loops.push_back(std::move(loop));
    }
  }
  add_followers(roads, seams);
  seams.loops.shrink_to_fit();
  seams.followers.shrink_to_fit();
  return seams;
}

}  // namespace core
