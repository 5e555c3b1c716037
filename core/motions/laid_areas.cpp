#include "core/motions/laid_areas.h"

#include <utility>

namespace core {
namespace {

ChangedAreas laying(const ChangedAreas& areas) {
  ChangedAreas some;
  for (const ChangedArea& area : areas) {
    if (!area.change.lays_otherwise()) continue;
    AreaChange change;
    change.laid = area.change.laid;
    some.push_back({change, area.region});
  }
  return parted(some);
}

bool is_of_part(RoadKind kind) {
  switch (kind) {
    case RoadKind::kSkirt:
    case RoadKind::kBrim:
    case RoadKind::kRaft:
    case RoadKind::kSupport:
    case RoadKind::kSupportInterface:
      return false;
    case RoadKind::kOuterPerimeter:
    case RoadKind::kPerimeter:
    case RoadKind::kSolid:
    case RoadKind::kGapFill:
    case RoadKind::kLoose:
    case RoadKind::kOverhangPerimeter:
    case RoadKind::kTopSolid:
    case RoadKind::kBottomSolid:
    case RoadKind::kBridge:
    case RoadKind::kInternalBridge:
    case RoadKind::kIroning:
      break;
  }
  return true;
}

std::optional<LaidValue> flow_of(RoadKind kind) {
  switch (kind) {
    case RoadKind::kOuterPerimeter:
      return LaidValue::kOuterPerimeterFlow;
    case RoadKind::kPerimeter:
      return LaidValue::kPerimeterFlow;
    case RoadKind::kOverhangPerimeter:
      return LaidValue::kOverhangFlow;
    case RoadKind::kBridge:
      return LaidValue::kBridgeFlow;
    case RoadKind::kInternalBridge:
      return LaidValue::kInternalBridgeFlow;
    case RoadKind::kSolid:
      return LaidValue::kSolidFlow;
    case RoadKind::kTopSolid:
      return LaidValue::kTopFlow;
    case RoadKind::kBottomSolid:
      return LaidValue::kBottomFlow;
    case RoadKind::kLoose:
      return LaidValue::kLooseFlow;
    case RoadKind::kGapFill:
      return LaidValue::kGapFlow;
    case RoadKind::kSkirt:
    case RoadKind::kBrim:
    case RoadKind::kRaft:
    case RoadKind::kSupport:
    case RoadKind::kSupportInterface:
    case RoadKind::kIroning:
      break;
  }
  return std::nullopt;
}

}  // namespace

Settings laid_settings(Settings settings, const AreaChange& change) {
  const auto set = [&](LaidValue which, double& setting) {
    setting = change.value(which).value_or(setting);
  };
  set(LaidValue::kPerimeterSpeed, settings.perimeter_speed_mm_s);
  set(LaidValue::kOuterPerimeterSpeed, settings.outer_perimeter_speed_mm_s);
  set(LaidValue::kSmallPerimeterSpeed, settings.small_perimeter_speed_mm_s);
  set(LaidValue::kOverhangSpeed1, settings.overhang_speed_mm_s[0]);
  set(LaidValue::kOverhangSpeed2, settings.overhang_speed_mm_s[1]);
  set(LaidValue::kOverhangSpeed3, settings.overhang_speed_mm_s[2]);
  set(LaidValue::kOverhangSpeed4, settings.overhang_speed_mm_s[3]);
  set(LaidValue::kBridgeSpeed, settings.bridge_speed_mm_s);
  set(LaidValue::kInternalBridgeSpeed, settings.internal_bridge_speed_mm_s);
  set(LaidValue::kSolidSpeed, settings.solid_speed_mm_s);
  set(LaidValue::kTopSpeed, settings.top_speed_mm_s);
  set(LaidValue::kIroningSpeed, settings.ironing_speed_mm_s);
  set(LaidValue::kLooseSpeed, settings.loose_speed_mm_s);
  set(LaidValue::kRestSpeed, settings.rest_speed_mm_s);
  return settings;
}

double flow_share(const AreaChange& change, RoadKind kind) {
  if (!is_of_part(kind)) return 1;
  const double all = change.value(LaidValue::kFlow).value_or(1);
  const std::optional<LaidValue> own = flow_of(kind);
  return own ? all * change.value(*own).value_or(1) : all;
}

LaidAreas::LaidAreas(const std::shared_ptr<const ChangedAreas>& areas, const Settings& settings) {
  if (!areas) return;
  std::vector<Region> regions;
  for (ChangedArea& area : laying(*areas)) {
    parts_.push_back({area.change, laid_settings(settings, area.change)});
    regions.push_back(std::move(area.region));
  }
  if (!regions.empty()) pieces_ = AreaPieces(regions);
}

std::vector<WidthStretch> LaidAreas::cut(std::vector<WidthStretch> stretches) const {
  if (parts_.empty()) return stretches;
  std::vector<WidthStretch> cut;
  for (WidthStretch& stretch : stretches) {
    if (!is_of_part(stretch.kind)) {
      cut.push_back(std::move(stretch));
      continue;
    }
    std::vector<Point> way = stretch.points;
    if (stretch.closed) way.push_back(way.front());
    std::vector<AreaPiece> found = pieces_.cut(way);
    for (AreaPiece& piece : found) {
      WidthStretch own = stretch;
      if (found.size() > 1) {
        own.closed = false;
        own.points = std::move(piece.points);
      }
      own.area = piece.area;
      if (own.area >= 0) {
        own.area_mm2 *= flow_share(parts_[static_cast<std::size_t>(own.area)].change, own.kind);
      }
      cut.push_back(std::move(own));
    }
    if (found.empty()) cut.push_back(std::move(stretch));
  }
  return cut;
}

}  // namespace core
