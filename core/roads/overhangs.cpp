#include "core/roads/overhangs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/regions/contour_proximity.h"  // frechet_within
#include "core/regions/polyline.h"           // between, distance_units
#include "core/regions/segment_grid.h"       // SegmentGrid
#include "core/vector.h"                     // Vector

namespace core {
namespace {

// Contours farther away don't matter, in widths of a road.
constexpr double kSightWidths = 2;

// A place and its depth, in units.
struct SeenFrom {
  Point point;
  double depth = 0;
};

// A contour seen from a place: how far, and on which side. Nothing where none is within sight.
class DepthBelow {
 public:
  DepthBelow(const Region& below, Length sight)
      : below_(below),
        sight_(static_cast<double>(sight.units())),
        edges_(edges_of(below.rings())),
        grid_(Length::from_units(1 + sight.units() / kCellsInSight), edges_) {}

  // In units; positive inside. `before`: a place nearer than sight, if there is one.
  [[nodiscard]] double at(Point point, std::optional<SeenFrom> before) {
    const auto reach = static_cast<std::int32_t>(reach_from(point, before));
    near_.clear();
    grid_.collect({{point.x - reach, point.y - reach}, {point.x + reach, point.y + reach}}, near_);
    const Vector p = to_vector(point);
    double least = sight_ * sight_;
    Vector nearest, inwards;
    bool seen = false;
    for (const std::uint32_t number : near_) {
      const Vector a = to_vector(edges_[number].from), along = to_vector(edges_[number].to) - a;
      const double length2 = dot(along, along);
      const double t = std::clamp(dot(p - a, along) / length2, 0.0, 1.0);
      const Vector q = a + along * t;
      const double away2 = dot(p - q, p - q);
      if (away2 > least + kSame) continue;
      const Vector normal = left_of(along) * (1 / std::sqrt(length2));
      // At a corner both edges count (the normal of a polygon's vertex).
      const bool corner = seen && away2 >= least - kSame;
      inwards = corner ? inwards + normal : normal;
      nearest = q;
      least = std::min(least, away2);
      seen = true;
    }
    if (!seen) return inside(point, before) ? sight_ : -sight_;
    const double away = std::sqrt(least);
    return dot(p - nearest, inwards) >= 0 ? away : -away;
  }

  // Whether all contours are surely farther than `reach` from all of the line.
  [[nodiscard]] bool clear_of(const Segment& line, double reach) {
    const auto r = static_cast<std::int32_t>(reach) + 1;
    Box box = box_of(line);
    box.min = {box.min.x - r, box.min.y - r};
    box.max = {box.max.x + r, box.max.y + r};
    near_.clear();
    grid_.collect(box, near_);
    return std::all_of(near_.begin(), near_.end(), [&](std::uint32_t number) {
      const Segment& edge = edges_[number];
      if (!box.overlaps(core::box_of(edge))) return true;
      return farther(line.from, edge, reach) && farther(line.to, edge, reach) &&
             farther(edge.from, line, reach) && farther(edge.to, line, reach) && !cross(line, edge);
    });
  }

 private:
  static constexpr double kSame = 1e-3;  // square units
  static constexpr std::int64_t kCellsInSight = 4;

  [[nodiscard]] bool inside(Point point, const std::optional<SeenFrom>& before) const {
    return before ? before->depth >= 0 : below_.contains(point);
  }

  // How far the nearest contour can be: no farther than it was, and the way from there.
  [[nodiscard]] double reach_from(Point point, const std::optional<SeenFrom>& before) const {
    if (!before || std::abs(before->depth) >= sight_) return sight_;
    return std::min(sight_, std::abs(before->depth) + distance_units(before->point, point) + 1);
  }

  static bool farther(Point point, const Segment& line, double reach) {
    const Vector away = to_vector(point) - to_vector(line.from);
    const Vector along = to_vector(line.to) - to_vector(line.from);
    const Vector off = away - along * share_along(away, along);
    return dot(off, off) > reach * reach;
  }

  // For lines whose ends lie on neither.
  static bool cross(const Segment& a, const Segment& b) {
    const auto left = [](const Segment& line, Point point) {
      return core::cross(line.from, line.to, point) > 0;
    };
    return left(a, b.from) != left(a, b.to) && left(b, a.from) != left(b, a.to);
  }

  const Region& below_;
  double sight_;
  std::vector<Segment> edges_;
  SegmentGrid grid_;
  std::vector<std::uint32_t> near_;
};

// A place on a road: a point of it, or one between two points.
struct Place {
  Point point;
  Length width;
  Hold hold = Hold::kWhole;  // from here to the next place
  bool corner = false;       // a point of the road
};

// How far a place may move before its hold can change, in units.
double slack(double depth, double width) {
  double least = std::abs(depth - (kWhollyHeldShare - 0.5) * width);
  for (const double share : {0.25, 0.0, -0.25}) {
    least = std::min(least, std::abs(depth - share * width));
  }
  return least;
}

// Where roads are held wholly: at this depth and deeper, in units. Places lie on the grid.
double whole_depth(const Road& road) {
  return (kWhollyHeldShare - 0.5) * static_cast<double>(widest(road).units()) + 2;
}

std::size_t segment_count(const Road& road) {
  return road.closed ? road.points.size() : road.points.size() - 1;
}

Segment segment_of(const Road& road, std::size_t i) {
  return {road.points[i], road.points[(i + 1) % road.points.size()]};
}

// By segment: whether no contour comes so near that its hold could change along it.
std::vector<bool> clear_segments(const Road& road, DepthBelow& below) {
  const double reach = whole_depth(road);
  std::vector<bool> clear(segment_count(road));
  for (std::size_t i = 0; i < clear.size(); ++i) {
    clear[i] = below.clear_of(segment_of(road, i), reach);
  }
  return clear;
}

// Segments that are clear have one hold, and are one place if that is a whole one.
std::vector<Place> places_of(const Road& road, DepthBelow& below, const std::vector<bool>& clear) {
  const auto step = static_cast<double>(kHoldStep.units());
  std::vector<Place> places;
  std::optional<SeenFrom> seen;
  const double deep = whole_depth(road);
  bool inside = false;  // the place before is as deep as that
  const std::size_t count = road.points.size();
  for (std::size_t i = 0; i < clear.size(); ++i) {
    const std::size_t j = (i + 1) % count;
    const Point from = road.points[i], to = road.points[j];
    if (clear[i] && inside) {
      places.push_back({from, width_at(road, i), Hold::kWhole, true});
      continue;
    }
    const double length = distance_units(from, to);
    const double a = width_at(road, i).mm(), b = width_at(road, j).mm();
    for (double way = 0; way == 0 || way < length;) {
      const double t = length > 0 ? way / length : 0;
      const Point point = way == 0 ? from : between(from, to, t);
      const Length width = Length::from_mm(a + (b - a) * t);
      const auto w = static_cast<double>(width.units());
      const double depth = below.at(point, seen);
      seen = {point, depth};
      places.push_back({point, width, hold_of(0.5 + depth / w), way == 0});
      inside = clear[i] && depth > deep;
      if (inside) break;
      way += std::max(step, slack(depth, w));
    }
  }
  if (!road.closed) places.push_back({road.points.back(), width_at(road, count - 1), {}, true});
  return places;
}

// Where one hold begins and where it ends, among the places of a road.
struct Run {
  std::size_t first = 0;
  std::size_t end = 0;
  double mm = 0;
  Hold hold = Hold::kWhole;
};

std::vector<Run> runs_of(const std::vector<Place>& places, bool closed) {
  std::vector<Run> runs;
  const std::size_t count = closed ? places.size() : places.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    if (runs.empty() || runs.back().hold != places[i].hold) {
      runs.push_back({i, i, 0, places[i].hold});
    }
    runs.back().end = i + 1;
    runs.back().mm += distance_mm(places[i].point, places[(i + 1) % places.size()].point);
  }
  // A closed road goes on from its last run to its first.
  if (closed && runs.size() > 1 && runs.front().hold == runs.back().hold) {
    runs.front().mm = runs.back().mm = runs.front().mm + runs.back().mm;
  }
  return runs;
}

// Every run shorter than `shortest_mm` is held as the longer one beside it, until none is left.
void smooth(std::vector<Place>& places, bool closed, double shortest_mm) {
  for (std::vector<Run> runs = runs_of(places, closed); runs.size() > 1;
       runs = runs_of(places, closed)) {
    std::vector<bool> changed(runs.size());
    bool any = false;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (runs[i].mm >= shortest_mm) continue;
      const bool first = i == 0, last = i + 1 == runs.size();
      const std::size_t before = first ? (closed ? runs.size() - 1 : 1) : i - 1;
      const std::size_t after = last ? (closed ? 0 : i - 1) : i + 1;
      if (changed[before] || changed[after]) continue;
      const Run& longer = runs[before].mm >= runs[after].mm ? runs[before] : runs[after];
      if (longer.hold == runs[i].hold) continue;  // both ends of a closed road
      for (std::size_t k = runs[i].first; k < runs[i].end; ++k) places[k].hold = longer.hold;
      changed[i] = any = true;
    }
    if (!any) return;
  }
}

void mark(DepthBelow& below, Road& road) {
  const std::vector<bool> clear = clear_segments(road, below);
  // Most roads are held wholly: one place tells for all of it.
  const bool all_clear = std::find(clear.begin(), clear.end(), false) == clear.end();
  if (all_clear && below.at(road.points.front(), std::nullopt) > whole_depth(road)) return;
  std::vector<Place> places = places_of(road, below, clear);
  smooth(places, road.closed, road.width.mm());
  const std::size_t stretches = road.closed ? places.size() : places.size() - 1;
  const bool whole =
      std::all_of(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(stretches),
                  [](const Place& p) { return p.hold == Hold::kWhole; });
  if (whole) return;
  const bool wide = !road.widths.empty();
  road.points.clear();
  road.widths.clear();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place& place = places[i];
    const bool changes = i > 0 && i < stretches && places[i - 1].hold != place.hold;
    if (!place.corner && !changes) continue;
    if (!road.points.empty() && road.points.back() == place.point) {
      road.holds.back() = place.hold;
      continue;
    }
    road.points.push_back(place.point);
    road.holds.push_back(place.hold);
    if (wide) road.widths.push_back(place.width);
  }
  if (!road.closed) road.holds.back() = road.holds[road.holds.size() - 2];
}

bool alike(const Region& slice, const Region& below, Length reach) {
  return frechet_within(slice, below, reach) && frechet_within(below, slice, reach);
}

}  // namespace

Hold hold_of(double share) {
  if (share >= kWhollyHeldShare) return Hold::kWhole;
  if (share > 0.75) return Hold::kThreeQuarters;
  if (share > 0.5) return Hold::kHalf;
  return share > 0.25 ? Hold::kQuarter : Hold::kLittle;
}

void mark_holds(const Region& slice, const Region& below, const Settings& settings,
                std::vector<Road>& roads) {
  const Length width = settings.road_width;
  if (alike(slice, below, Length::from_mm(width.mm() * (1 - kWhollyHeldShare)))) return;
  // An outer road lies between the contour and all others.
  const bool only_outer = alike(slice, below, settings.road_width_min);
  std::optional<DepthBelow> depth;
  for (Road& road : roads) {
    const bool outer = road.kind == RoadKind::kOuterPerimeter;
    if (!outer && (only_outer || road.kind != RoadKind::kPerimeter)) continue;
    if (!depth) depth.emplace(below, Length::from_mm(width.mm() * kSightWidths));
    mark(*depth, road);
  }
}

}  // namespace core
