#include "core/motions/road_accelerations.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "core/motions/height_slowdown.h"  // height_share

namespace core {
namespace {

// The first of them that is set; 0: none is.
double first_set(std::initializer_list<double> accelerations) {
  for (const double each : accelerations) {
    if (each > 0) return each;
  }
  return 0;
}

double own_acceleration(const Settings& s, RoadKind kind) {
  switch (kind) {
    case RoadKind::kPerimeter:
      return s.perimeter_acceleration_mm_s2;
    case RoadKind::kOuterPerimeter:
      return first_set({s.outer_perimeter_acceleration_mm_s2, s.perimeter_acceleration_mm_s2});
    case RoadKind::kOverhangPerimeter:
      return first_set({s.bridge_acceleration_mm_s2, s.outer_perimeter_acceleration_mm_s2,
                        s.perimeter_acceleration_mm_s2});
    case RoadKind::kBridge:
    case RoadKind::kInternalBridge:
      return first_set({s.bridge_acceleration_mm_s2, s.loose_acceleration_mm_s2});
    case RoadKind::kLoose:
      return s.loose_acceleration_mm_s2;
    case RoadKind::kSolid:
    case RoadKind::kBottomSolid:
      return first_set({s.solid_acceleration_mm_s2, s.loose_acceleration_mm_s2});
    case RoadKind::kTopSolid:
    case RoadKind::kIroning:
      return first_set(
          {s.top_acceleration_mm_s2, s.solid_acceleration_mm_s2, s.loose_acceleration_mm_s2});
    case RoadKind::kSkirt:
    case RoadKind::kBrim:
    case RoadKind::kGapFill:
    case RoadKind::kRaft:
    case RoadKind::kSupport:
    case RoadKind::kSupportInterface:
      break;
  }
  return 0;
}

double at_height(const Settings& settings, double mm_s2, Length top) {
  if (mm_s2 == 0) return 0;
  return std::max(
      1.0, std::round(mm_s2 * height_share(settings, top, settings.height_slowdown_acceleration)));
}

}  // namespace

double road_acceleration_mm_s2(const Settings& settings, LayerIndex layer, Length top,
                               RoadKind kind) {
  if (settings.default_acceleration_mm_s2 == 0) return 0;
  const double first = layer == 0 ? settings.first_layer_acceleration_mm_s2 : 0;
  const double mm_s2 =
      first_set({first, own_acceleration(settings, kind), settings.default_acceleration_mm_s2});
  return at_height(settings, mm_s2, top);
}

double travel_acceleration_mm_s2(const Settings& settings, Length top) {
  if (settings.default_acceleration_mm_s2 == 0) return 0;
  return at_height(settings, settings.travel_acceleration_mm_s2, top);
}

}  // namespace core
