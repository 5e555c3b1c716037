#include "core/roads/short_ways.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/geometry.h"              // Box, Point, Segment
#include "core/regions/polyline.h"      // distance_mm, distance_units
#include "core/regions/segment_grid.h"  // SegmentGrid
#include "core/units.h"                 // Length

namespace core {
namespace {

// Cells of this size hold few edges, and a short way meets few of them.
constexpr Length kCell = Length::from_units(10'000);

bool is_perimeter(RoadKind kind) {
  return kind == RoadKind::kPerimeter || kind == RoadKind::kOuterPerimeter ||
         kind == RoadKind::kOverhangPerimeter;
}

// Of one layer's thickness: a way between thicker ones would be too thin.
bool is_fill(const Road& road) {
  if (road.layers > 1) return false;
  return road.kind == RoadKind::kSolid || road.kind == RoadKind::kBottomSolid ||
         road.kind == RoadKind::kInternalBridge || road.kind == RoadKind::kGapFill ||
         road.kind == RoadKind::kLoose;
}

// Where the nozzle is after it.
Point end_of(const Road& road, const Settings& settings) {
  return road.closed ? opened(road, settings.seam_gap).points.back() : road.points.back();
}

// Of two segments that don't cross.
double distance_between(const Segment& a, const Segment& b) {
  return std::min({distance_units(a.from, b), distance_units(a.to, b), distance_units(b.from, a),
                   distance_units(b.to, a)});
}

Box grown(Box box, double by) {
  const auto more = static_cast<std::int32_t>(std::ceil(by));
  return {{box.min.x - more, box.min.y - more}, {box.max.x + more, box.max.y + more}};
}

// What no way may cross.
class Obstacles {
 public:
  Obstacles(const Region& slice, const std::vector<Road>& roads)
      : contours_(edges_of(slice.rings())),
        contour_grid_(kCell, contours_),
        perimeter_grid_(kCell, perimeter_edges(roads)) {}

  [[nodiscard]] bool leave_free(const Segment& way, double half_width) const {
    if (perimeter_grid_.crosses(way) || contour_grid_.crosses(way)) return false;
    std::vector<std::uint32_t> near;
    contour_grid_.collect(grown(box_of(way), half_width), near);
    return std::none_of(near.begin(), near.end(), [&](std::uint32_t number) {
      return distance_between(way, contours_[number]) < half_width;
    });
  }

 private:
  static std::vector<Segment> perimeter_edges(const std::vector<Road>& roads) {
    std::vector<Segment> edges;
    for (const Road& road : roads) {
      if (!is_perimeter(road.kind)) continue;
      for (std::size_t i = 1; i < road.points.size(); ++i) {
        edges.push_back({road.points[i - 1], road.points[i]});
      }
      if (road.closed) edges.push_back({road.points.back(), road.points.front()});
    }
    return edges;
  }

  std::vector<Segment> contours_;
  SegmentGrid contour_grid_;
  SegmentGrid perimeter_grid_;
};

}  // namespace

void lay_short_ways(const Region& slice, const Settings& settings, std::vector<Road>& roads) {
  const double half_width = static_cast<double>(settings.road_width_min.units()) / 2;
  std::optional<Obstacles> obstacles;
  std::vector<Segment> ways(roads.size());  // before each road; a point: none
  std::size_t count = 0;
  for (std::size_t i = 1; i < roads.size(); ++i) {
    if (!is_fill(roads[i - 1]) || !is_fill(roads[i])) continue;
    const Segment way{end_of(roads[i - 1], settings), roads[i].points.front()};
    if (way.from == way.to || distance_mm(way.from, way.to) > kShortWayMax.mm()) continue;
    if (!obstacles) obstacles.emplace(slice, roads);
    if (!obstacles->leave_free(way, half_width)) continue;
    if (roads[i - 1].closed) roads[i - 1] = opened(std::move(roads[i - 1]), settings.seam_gap);
    ways[i] = way;
    ++count;
  }
  if (count == 0) return;
  std::vector<Road> all;
  all.reserve(roads.size() + count);
  for (std::size_t i = 0; i < roads.size(); ++i) {
    if (ways[i].from != ways[i].to) {
      all.push_back(
          {RoadKind::kGapFill, settings.road_width_min, false, {ways[i].from, ways[i].to}});
    }
    all.push_back(std::move(roads[i]));
  }
  roads = std::move(all);
}

}  // namespace core
