#include "core/roads/travel_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/offsets/offset_contours.h"  // flatten
#include "core/offsets/polygon_offset.h"   // PolygonOffsetter
#include "core/regions/polyline.h"         // between, distance_mm, length_mm
#include "core/regions/simplify.h"         // kept_points

namespace core {
namespace {

constexpr Length kCell = Length::from_units(20'000);
constexpr Length kArcTolerance = Length::from_units(100);

// What a followed line may be moved, as a share of its depth: it stays off the bounds.
constexpr double kFollowSlack = 0.25;
// How far a place may be from the line that it goes to, in depths of the line.
constexpr double kReach = 2;

Length part_of(Length length, double share) {
  return Length::from_units(std::llround(static_cast<double>(length.units()) * share));
}

}  // namespace

TravelSpace::TravelSpace(const Region& slice, Length road_width, Length max_detour)
    : islands_(slice), max_detour_(max_detour) {
  const Length half = part_of(road_width, 0.5), quarter = part_of(road_width, 0.25);
  const std::array<Length, 4> depths = {part_of(road_width, 0.4), road_width, half, quarter};
  std::array<OffsetContours, 4> cut;
  PolygonOffsetter().offset(slice, depths, cut);
  const auto region = [&cut](std::size_t i) { return flatten(cut[i], kArcTolerance); };
  levels_.push_back(std::make_unique<Level>(region(1), region(0), road_width));
  levels_.push_back(std::make_unique<Level>(region(2), slice, half));
  levels_.push_back(std::make_unique<Level>(region(3), slice, quarter));
}

std::vector<Point> TravelSpace::way(Point from, Point to) const {
  std::vector<Point> straight = {from, to};
  if (from == to || islands_.island_of(from) != islands_.island_of(to)) return straight;
  for (const auto& level : levels_) {
    std::vector<Point> way = level->way(from, to);
    if (way.empty()) continue;
    const double detour_mm = length_mm(way, false) - distance_mm(from, to);
    if (max_detour_ > Length() && detour_mm > max_detour_.mm()) return straight;
    return way;
  }
  return straight;
}

TravelSpace::Level::Level(Region lines, const Region& bounds, Length depth)
    : lines_(std::move(lines)),
      along_(lines_),
      within_(lines_),
      bounds_(kCell, bounds),
      depth_(depth) {}

std::vector<Point> TravelSpace::Level::way(Point from, Point to) const {
  if (!bounds_.crosses({from, to})) return {from, to};
  std::vector<BoundaryPoint> events, last;
  if (!entered(from, events) || !entered(to, last)) return {};
  const Point first = events.empty() ? from : events.front().at;
  along_.append_crossings(first, last.empty() ? to : last.front().at, events);
  events.insert(events.end(), last.begin(), last.end());
  std::vector<Point> way = {from};
  if (!follow(events, way)) return {};
  way.push_back(to);
  std::vector<Point> kept;
  for (const std::size_t i : kept_points(way, part_of(depth_, kFollowSlack))) {
    kept.push_back(way[i]);
  }
  return shortened(kept);
}

// Where a point outside the lines goes to; nothing to do for one within them.
bool TravelSpace::Level::entered(Point at, std::vector<BoundaryPoint>& events) const {
  if (lines_.empty()) return false;
  if (within_.contains(at)) return true;
  const std::optional<BoundaryPoint> near = along_.nearest(at, part_of(depth_, kReach));
  if (near) events.push_back(*near);
  return near.has_value();
}

// The straight way enters and leaves the lines at these places. Each stretch outside ends on the
// contour on which it began.
bool TravelSpace::Level::follow(const std::vector<BoundaryPoint>& events,
                                std::vector<Point>& way) const {
  for (std::size_t i = 0; i < events.size(); ++i) {
    const BoundaryPoint& from = events[i];
    way.push_back(from.at);
    if (i + 1 == events.size()) break;
    if (within_.contains(between(from.at, events[i + 1].at, 0.5))) continue;
    std::size_t end = i + 1;
    if (events[end].place.ring != from.place.ring) {
      for (end = events.size() - 1; end > i; --end) {
        if (events[end].place.ring == from.place.ring) break;
      }
      if (end == i) return false;
    }
    follow(from, events[end], way);
    way.push_back(events[end].at);
    i = end;
    // At a stretch's end the next one may begin, if the end is a corner's.
    if (i + 1 < events.size() && !within_.contains(between(events[i].at, events[i + 1].at, 0.5))) {
      --i;
    }
  }
  return true;
}

void TravelSpace::Level::follow(const BoundaryPoint& from, const BoundaryPoint& to,
                                std::vector<Point>& way) const {
  const double round = along_.ring_length(from.place.ring);
  const double forwards = to.place.along - from.place.along;
  const bool is_shorter = (forwards < 0 ? forwards + round : forwards) * 2 <= round;
  along_.append_way(from.place, to.place, is_shorter, way);
}

// From each point on to the farthest that can be seen. Empty where even the next one can't.
std::vector<Point> TravelSpace::Level::shortened(const std::vector<Point>& way) const {
  std::vector<Point> result = {way.front()};
  int looks = kLooksMax;
  for (std::size_t i = 0; i + 1 < way.size();) {
    std::size_t next = way.size() - 1;
    while (next > i + 1 && (looks <= 0 || bounds_.crosses({way[i], way[next]}))) {
      --next;
      --looks;
    }
    if (next == i + 1 && bounds_.crosses({way[i], way[next]})) return {};
    if (way[next] != result.back()) result.push_back(way[next]);
    i = next;
  }
  return result;
}

}  // namespace core
