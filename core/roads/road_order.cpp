#include "core/roads/road_order.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/check.h"                    // RIND_CHECK
#include "core/regions/region.h"           // doubled_area_units
#include "core/roads/nearest_point.h"      // NearestPoint
#include "core/roads/order_improvement.h"  // improve_order
#include "core/trigonometry.h"             // hypotenuse

namespace core {

namespace {

// A turn sharper than this (about 30°) is a corner that hides a seam.
constexpr double kCornerCosine = 0.87;

// Island parts are printed in this order.
constexpr int kStages = 8;

// Roads of these stages are in order already (wall_fill.h): bottoms, tops, ironing.
constexpr bool in_order(int stage) { return stage == 3 || stage >= 6; }

// A hole's perimeter that nothing holds: the bridge beside it comes before.
bool hole_in_air(const Road& road) {
  return road.closed && in_air(road) && doubled_area_units(road.points) < 0;
}

// Whether its centre line is in the air somewhere.
bool overhangs(const Road& road) {
  return std::any_of(road.holds.begin(), road.holds.end(),
                     [](Hold hold) { return hold >= Hold::kQuarter; });
}

// What overhangs hangs on the perimeter inside it, and comes after that.
int stage(const Road& road, bool outer_first) {
  if (hole_in_air(road)) return 5;
  switch (road.kind) {
    case RoadKind::kSkirt:
    case RoadKind::kBrim:
    case RoadKind::kPerimeter:
      return 1;
    case RoadKind::kOuterPerimeter:
    case RoadKind::kOverhangPerimeter:
      return outer_first && !overhangs(road) ? 0 : 2;
    case RoadKind::kBottomSolid:
      return 3;
    case RoadKind::kBridge:
    case RoadKind::kInternalBridge:
    case RoadKind::kSolid:
    case RoadKind::kGapFill:
    case RoadKind::kLoose:
    case RoadKind::kRaft:
    case RoadKind::kSupport:
    case RoadKind::kSupportInterface:
      return 4;
    case RoadKind::kTopSolid:
      return 6;
    case RoadKind::kIroning:
      break;
  }
  return 7;
}

bool corner(Point a, Point b, Point c) {
  const double ux = static_cast<double>(b.x) - a.x, uy = static_cast<double>(b.y) - a.y;
  const double vx = static_cast<double>(c.x) - b.x, vy = static_cast<double>(c.y) - b.y;
  return ux * vx + uy * vy < kCornerCosine * hypotenuse(ux, uy) * hypotenuse(vx, vy);
}

void add_begins(const Road& road, std::size_t owner, std::vector<NearestPoint::Entry>& entries) {
  const std::vector<Point>& points = road.points;
  if (!road.closed) {
    entries.push_back({points.front(), owner, 0});
    entries.push_back({points.back(), owner, points.size() - 1});
    return;
  }
  for (const std::uint32_t i : road.starts) entries.push_back({points[i], owner, i});
  if (!road.starts.empty()) return;
  const std::size_t before = entries.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point a = points[(i + points.size() - 1) % points.size()];
    if (corner(a, points[i], points[(i + 1) % points.size()])) {
      entries.push_back({points[i], owner, i});
    }
  }
  if (entries.size() != before) return;
  for (std::size_t i = 0; i < points.size(); ++i) entries.push_back({points[i], owner, i});
}

// Turns the road so that it starts at its point `index`; returns where it ends.
Point turn_to(Road& road, std::size_t index) {
  if (road.closed) {
    start_at(road, index);
    return road.points.front();
  }
  if (index != 0) reverse(road);
  return road.points.back();
}

}  // namespace

std::vector<Road> nearest_order(std::vector<Road> roads, Point& at) {
  std::vector<NearestPoint::Entry> entries;
  for (std::size_t i = 0; i < roads.size(); ++i) add_begins(roads[i], i, entries);
  NearestPoint starts(std::move(entries));
  std::vector<Road> ordered;
  ordered.reserve(roads.size());
  for (std::size_t count = 0; count < roads.size(); ++count) {
    const auto next = starts.nearest(at);
    RIND_CHECK(next.has_value());
    starts.remove_owner(next->owner);
    at = turn_to(roads[next->owner], next->index);
    ordered.push_back(std::move(roads[next->owner]));
  }
  return ordered;
}

static void append_in_stages(IslandRoads island, bool outer_first, Point& at,
                             std::vector<Road>& ordered) {
  std::vector<Road> stages[kStages];
  for (Road& road : island) stages[stage(road, outer_first)].push_back(std::move(road));
  for (int number = 0; number < kStages; ++number) {
    std::vector<Road>& part = stages[number];
    if (part.empty()) continue;
    if (!in_order(number)) {
      const Point from = at;
      part = nearest_order(std::move(part), at);
      improve_order(part, from);
    }
    at = part.back().closed ? part.back().points.front() : part.back().points.back();
    std::move(part.begin(), part.end(), std::back_inserter(ordered));
  }
}

std::vector<Road> printing_order(LayerRoads layer) {
  std::vector<Road> ordered = std::move(layer.first);
  if (layer.islands.empty()) return ordered;
  Point at = ordered.empty() ? layer.from : ordered.back().points.front();
  if (layer.islands.size() == 1) {
    append_in_stages(std::move(layer.islands.front()), layer.outer_first, at, ordered);
    return ordered;
  }
  std::vector<NearestPoint::Entry> entries;
  std::size_t roads = ordered.size();
  for (std::size_t island = 0; island < layer.islands.size(); ++island) {
    roads += layer.islands[island].size();
    for (const Road& road : layer.islands[island]) {
      for (std::size_t i = 0; i < road.points.size(); ++i) {
        entries.push_back({road.points[i], island, i});
      }
    }
  }
  NearestPoint islands_left(std::move(entries));
  ordered.reserve(roads);
  while (const auto next = islands_left.nearest(at)) {
    islands_left.remove_owner(next->owner);
    append_in_stages(std::move(layer.islands[next->owner]), layer.outer_first, at, ordered);
  }
  return ordered;
}

}  // namespace core
