#include "core/motions/laid_areas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/regions/polyline.h"  // between, distance_mm

namespace core {
namespace {

constexpr Length kCell = Length::from_units(10'000);

ChangedAreas laying(const ChangedAreas& areas) {
  ChangedAreas some;
  for (const ChangedArea& area : areas) {
    if (!area.change.lays_otherwise()) continue;
    AreaChange change;
    change.laid = area.change.laid;
    some.push_back({std::move(change), area.region});
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
  for (ChangedArea& area : laying(*areas)) {
    const std::vector<Segment> edges = edges_of(area.region.rings());
    edges_.insert(edges_.end(), edges.begin(), edges.end());
    parts_.push_back(
        {area.change, laid_settings(settings, area.change), PointLocation(area.region)});
  }
  if (!parts_.empty()) grid_.emplace(kCell, edges_);
}

int LaidAreas::area_at(Point point) const {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i].region.contains(point)) return static_cast<int>(i);
  }
  return WidthStretch::kNoArea;
}

// Shares of the way at which it meets a border, in their order.
std::vector<double> LaidAreas::crossings(const Segment& way) const {
  std::vector<std::uint32_t> near;
  grid_->collect_along(way, near);
  std::vector<double> shares;
  for (const std::uint32_t number : near) {
    const Segment& edge = edges_[number];
    const auto from = static_cast<double>(cross(edge.from, edge.to, way.from));
    const auto to = static_cast<double>(cross(edge.from, edge.to, way.to));
    if (from == to) continue;  // along the border, whose next edges cross the way
    shares.push_back(std::clamp(from / (from - to), 0.0, 1.0));
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

std::vector<LaidAreas::Piece> LaidAreas::pieces(const std::vector<Point>& points) const {
  std::vector<Piece> pieces;
  const auto add = [&](int area, Point from, Point to) {
    if (from == to) return;
    if (pieces.empty() || pieces.back().area != area) pieces.push_back({area, 0, {from}});
    pieces.back().points.push_back(to);
    pieces.back().length_mm += distance_mm(from, to);
  };
  bool asked = false;  // whether the piece at hand is known to go on
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Segment way{points[i - 1], points[i]};
    const std::vector<double> shares = crossings(way);
    if (shares.empty() && asked) {
      add(pieces.back().area, way.from, way.to);
      continue;
    }
    asked = shares.empty() && way.from != way.to;
    Point last = way.from;
    for (std::size_t k = 0; k <= shares.size(); ++k) {
      const Point next = k < shares.size() ? between(way.from, way.to, shares[k]) : way.to;
      if (next != last) add(area_at(between(last, next, 0.5)), last, next);
      last = next;
    }
  }
  // What is too short goes with what is beside it.
  std::vector<Piece> kept;
  for (Piece& piece : pieces) {
    const bool joins = !kept.empty() && (piece.length_mm < kAreaPieceMin.mm() ||
                                         kept.back().length_mm < kAreaPieceMin.mm() ||
                                         kept.back().area == piece.area);
    if (!joins) {
      kept.push_back(std::move(piece));
      continue;
    }
    Piece& before = kept.back();
    if (before.length_mm < kAreaPieceMin.mm()) before.area = piece.area;
    before.points.insert(before.points.end(), piece.points.begin() + 1, piece.points.end());
    before.length_mm += piece.length_mm;
  }
  return kept;
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
    std::vector<Piece> found = pieces(way);
    for (Piece& piece : found) {
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
