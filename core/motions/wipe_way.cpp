#include "core/motions/wipe_way.h"

#include <algorithm>
#include <utility>

#include "core/regions/polyline.h"  // between, distance_mm, length_mm
#include "core/regions/simplify.h"  // kept_points

namespace core {
namespace {

constexpr double kTravelShare = 0.8;  // the nozzle's speed, of that of travel

struct Way {
  std::vector<Point> points;
  bool whole = false;  // as long as asked
};

// The road's points, in the order in which they are wiped, as far as `length`.
Way way_over(const std::vector<Point>& road, bool loop, double length) {
  Way way{{road.back()}};
  const std::size_t count = road.size();
  for (std::size_t i = 0; i < count && !way.whole; ++i) {
    const Point from = way.points.back();
    const Point to = loop ? road[i] : road[count - 1 - i];
    const double mm = distance_mm(from, to);
    if (mm == 0) continue;
    way.whole = mm >= length;
    way.points.push_back(way.whole ? between(from, to, length / mm) : to);
    length -= mm;
  }
  return way;
}

}  // namespace

WipePlan wipe_plan(const std::vector<Point>& road, bool loop, const Settings& settings) {
  WipePlan plan;
  plan.before_mm = settings.retraction_mm;
  const double drawn_mm = settings.retraction_mm * (1 - settings.retraction_before_wipe);
  if (drawn_mm <= 0) return plan;
  const double seconds = drawn_mm / settings.retraction_speed_mm_s;
  const double fastest = kTravelShare * settings.travel_speed_mm_s;
  const bool asked = settings.wipe_distance > Length();
  const double distance = asked ? settings.wipe_distance.mm() : fastest * seconds;
  const Way way = way_over(road, loop, distance);
  std::vector<Point> kept;
  for (const std::size_t i : kept_points(way.points, settings.segment_tolerance)) {
    kept.push_back(way.points[i]);
  }
  const double length = length_mm(kept, false);
  if (length <= 0) return plan;
  // Leaving out points makes a way a little shorter.
  const double over = way.whole ? length : distance;
  plan.way = std::move(kept);
  plan.speed_mm_s = std::min(fastest, over / seconds);
  plan.filament_per_mm = drawn_mm / over;
  plan.before_mm = settings.retraction_mm - (way.whole ? drawn_mm : plan.filament_per_mm * length);
  return plan;
}

}  // namespace core
