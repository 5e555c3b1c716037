#include "core/motions/cooling.h"

#include <algorithm>
#include <cmath>

#include "core/regions/polyline.h"  // distance_mm, length_mm

namespace core {
namespace {

// A layer that was slowed down to its least time is not below it.
constexpr double kTimeTolerance = 1e-6;

double laying_s(const Settings& settings, const std::vector<LaidWay>& ways, Slowing slowing,
                double slowdown) {
  double sum = 0;
  for (const LaidWay& way : ways) {
    if (way.slowing != slowing) continue;
    sum +=
        way.length_mm / slowed_speed_mm_s(way.speed_mm_s, slowdown, settings.slowed_speed_min_mm_s);
  }
  return sum;
}

}  // namespace

double slowdown_of(const LayerCooling& cooling, Slowing slowing) {
  switch (slowing) {
    case Slowing::kFirst:
      return cooling.slowdown;
    case Slowing::kLast:
      return cooling.last_slowdown;
    case Slowing::kNever:
      break;
  }
  return 1;
}

Slowing slowing_of(RoadKind kind) {
  const bool bridge = kind == RoadKind::kBridge || kind == RoadKind::kInternalBridge;
  const bool outer = kind == RoadKind::kOuterPerimeter || kind == RoadKind::kOverhangPerimeter;
  return bridge ? Slowing::kNever : outer ? Slowing::kLast : Slowing::kFirst;
}

double in_whole_percents(double share) { return std::floor(share * 100 + 1e-6) / 100; }

double slowed_speed_mm_s(double full_mm_s, double slowdown, double slowest_mm_s) {
  return std::max(full_mm_s * slowdown, std::min(full_mm_s, slowest_mm_s));
}

double fan_growth(const Settings& settings, LayerIndex index) {
  const LayerIndex layer = index + 1;
  // A fan that comes on gradually is off on the first layer at least.
  const int from = std::max(settings.fan_from_layer, settings.fan_full_layer > 0 ? 2 : 1);
  if (layer < from) return 0;
  if (layer >= settings.fan_full_layer) return 1;
  return static_cast<double>(layer - from + 1) / (settings.fan_full_layer - from + 1);
}

double fan_share(const Settings& settings, LayerIndex index, double layer_s) {
  const double growth = fan_growth(settings, index);
  if (growth == 0) return 0;
  const double most = settings.fan_share;
  const double least = std::min(settings.fan_share_min, most);
  double share = settings.fan_always_on ? least : 0;
  if (settings.cool_short_layers) {
    const double short_s = settings.layer_time_min_s;
    const double long_s = settings.fan_below_layer_time_s;
    if (layer_s < short_s * (1 - kTimeTolerance)) {
      share = most;
    } else if (layer_s < long_s && short_s < long_s) {
      const double rest = std::max(0.0, layer_s - short_s) / (long_s - short_s);
      share = in_whole_percents(rest * least + (1 - rest) * most);
    }
  }
  return growth == 1 ? share : in_whole_percents(share * growth + 0.005);
}

LayerCooling layer_cooling(const Settings& settings, LayerIndex index, double travelling_s,
                           const std::vector<LaidWay>& ways) {
  const double first_s = laying_s(settings, ways, Slowing::kFirst, 1);
  const double last_s = laying_s(settings, ways, Slowing::kLast, 1);
  const double fixed_s = travelling_s + laying_s(settings, ways, Slowing::kNever, 1);
  LayerCooling cooling;
  double slowed_s = first_s;
  if (settings.cool_short_layers) {
    const double first_left_s = settings.layer_time_min_s - fixed_s - last_s;
    if (first_left_s > first_s) {
      cooling.slowdown = first_s / first_left_s;
      slowed_s = laying_s(settings, ways, Slowing::kFirst, cooling.slowdown);
    }
    const double last_left_s = settings.layer_time_min_s - fixed_s - slowed_s;
    if (last_left_s > last_s * (1 + kTimeTolerance)) cooling.last_slowdown = last_s / last_left_s;
  }
  slowed_s += laying_s(settings, ways, Slowing::kLast, cooling.last_slowdown);
  cooling.fan_share = fan_share(settings, index, fixed_s + slowed_s);
  return cooling;
}

}  // namespace core
