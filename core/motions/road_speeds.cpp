#include "core/motions/road_speeds.h"

#include <algorithm>
#include <cstddef>

#include "core/raft_heights.h"  // is_above_raft

namespace core {
namespace {

double speed_of_kind(const Settings& settings, RoadKind kind) {
  switch (kind) {
    case RoadKind::kSkirt:
    case RoadKind::kBrim:
    case RoadKind::kPerimeter:
      return settings.perimeter_speed_mm_s;
    case RoadKind::kOuterPerimeter:
    case RoadKind::kOverhangPerimeter:
      return settings.outer_perimeter_speed_mm_s;
    case RoadKind::kBridge:
      return settings.bridge_speed_mm_s;
    case RoadKind::kInternalBridge:
      return settings.internal_bridge_speed_mm_s;
    case RoadKind::kGapFill:
      return settings.rest_speed_mm_s;
    case RoadKind::kLoose:
      return settings.loose_speed_mm_s;
    case RoadKind::kTopSolid:
      return settings.top_speed_mm_s;
    case RoadKind::kIroning:
      return settings.ironing_speed_mm_s;
    case RoadKind::kSupport:
      return settings.support_speed_mm_s;
    case RoadKind::kSupportInterface:
      return settings.support_interface_speed_mm_s;
    case RoadKind::kSolid:
    case RoadKind::kBottomSolid:
    case RoadKind::kRaft:
      break;
  }
  return settings.solid_speed_mm_s;
}

bool is_perimeter(RoadKind kind) {
  return kind == RoadKind::kPerimeter || kind == RoadKind::kOuterPerimeter ||
         kind == RoadKind::kOverhangPerimeter;
}

std::size_t step_of(Hold hold) { return static_cast<std::size_t>(hold) - 1; }

}  // namespace

bool is_small_perimeter(const Road& road) {
  return road.closed && is_perimeter(road.kind) && length_mm(road) <= kSmallPerimeter_mm;
}

double flow_factor(const Settings& settings, LayerIndex layer) {
  return settings.extrusion_multiplier * (layer == 0 ? settings.first_layer_flow : 1);
}

double full_speed_mm_s(const Settings& settings, LayerIndex layer, const RoadSpeedCase& road) {
  double speed = speed_of_kind(settings, road.kind);
  if (settings.small_perimeter_speed_mm_s > 0 && road.small) {
    speed = std::min(speed, settings.small_perimeter_speed_mm_s);
  }
  const double limit =
      road.hold == Hold::kWhole ? 0 : settings.overhang_speed_mm_s[step_of(road.hold)];
  if (limit > 0) speed = std::min(speed, limit);
  const double flow_mm2 = road.area_mm2 * flow_factor(settings, layer);
  if (settings.volumetric_speed_max_mm3_s > 0) {
    speed = std::min(speed, settings.volumetric_speed_max_mm3_s / flow_mm2);
  }
  const bool slow = layer == 0 || is_above_raft(settings, layer);
  return slow ? std::min(speed, settings.first_layer_speed_mm_s) : speed;
}

double fan_share_least(const Settings& settings, RoadKind kind, Hold hold) {
  if (kind == RoadKind::kBridge || kind == RoadKind::kInternalBridge) {
    return settings.bridge_fan_share;
  }
  if (kind == RoadKind::kSupportInterface) return settings.support_interface_fan_share;
  return hold == Hold::kWhole ? 0 : settings.overhang_fan_share[step_of(hold)];
}

}  // namespace core
