#include "core/motions/cooling.h"

#include <algorithm>
#include <cmath>

#include "core/regions/polyline.h"  // distance_mm, length_mm

namespace core {
namespace {

// A layer that was slowed down to its least time is not below it.
constexpr double kTimeTolerance = 1e-6;

double in_whole_percents(double share) { return std::floor(share * 100 + 1e-6) / 100; }

double travelling_s(const Settings& settings, const std::vector<Road>& roads) {
  double mm = 0;
  for (std::size_t i = 1; i < roads.size(); ++i) {
    const Road& before = roads[i - 1];
    const Point from = before.closed ? before.points.front() : before.points.back();
    mm += distance_mm(from, roads[i].points.front());
  }
  return mm / settings.travel_speed_mm_s;
}

}  // namespace

double slowed_speed_mm_s(double full_mm_s, double slowdown, double slowest_mm_s) {
  return std::max(full_mm_s * slowdown, std::min(full_mm_s, slowest_mm_s));
}

double fan_share(const Settings& settings, LayerIndex index, double layer_s) {
  const LayerIndex layer = index + 1;
  // A fan that comes on gradually is off on the first layer at least.
  const int from = std::max(settings.fan_from_layer, settings.fan_full_layer > 0 ? 2 : 1);
  if (layer < from) return 0;
  const double most = settings.fan_share;
  const double least = std::min(settings.fan_share_min, most);
  double share = settings.fan_always_on ? least : 0;
  if (settings.cool_short_layers) {
    const double short_s = settings.layer_time_min_s;
    const double long_s = settings.fan_below_layer_time_s;
    if (layer_s < short_s * (1 - kTimeTolerance)) {
      share = most;
    } else if (layer_s < long_s) {
      const double rest = std::max(0.0, layer_s - short_s) / (long_s - short_s);
      share = in_whole_percents(rest * least + (1 - rest) * most);
    }
  }
  if (layer >= settings.fan_full_layer) return share;
  const double grown = static_cast<double>(layer - from + 1) / (settings.fan_full_layer - from + 1);
  return in_whole_percents(share * grown + 0.005);
}

LayerCooling layer_cooling(const Settings& settings, LayerIndex index,
                           const std::vector<Road>& roads,
                           const std::function<double(RoadKind)>& speed_mm_s) {
  const double travel_s = travelling_s(settings, roads);
  double laying_s = 0;
  for (const Road& road : roads) laying_s += length_mm(road) / speed_mm_s(road.kind);
  LayerCooling cooling;
  if (settings.cool_short_layers) {
    const double left_s = settings.layer_time_min_s - travel_s;
    if (left_s > laying_s) cooling.slowdown = laying_s / left_s;
  }
  double slowed_s = 0;
  for (const Road& road : roads) {
    slowed_s += length_mm(road) / slowed_speed_mm_s(speed_mm_s(road.kind), cooling.slowdown,
                                                    settings.slowed_speed_min_mm_s);
  }
  cooling.fan_share = fan_share(settings, index, travel_s + slowed_s);
  return cooling;
}

}  // namespace core
