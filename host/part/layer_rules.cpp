#include "host/part/layer_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "core/bed.h"              // Bed
#include "core/limits.h"           // kWallLayersMax
#include "core/motions/arc_fit.h"  // kArcSegmentsMin
#include "core/units.h"            // Length

namespace host {
namespace {

struct LeavingRoad {
  const char* name;
  const char* remedy;
};

LeavingRoad leaving_road(core::RoadKind kind) {
  switch (kind) {
    case core::RoadKind::kSkirt:
      return {"the skirt",
              "set skirt_loops=0, or a smaller skirt_distance, skirt_length_min, brim_width or "
              "raft_expansion"};
    case core::RoadKind::kBrim:
      return {"the brim", "set a smaller brim_width"};
    case core::RoadKind::kRaft:
      return {"the raft", "set a smaller raft_expansion"};
    case core::RoadKind::kSupport:
    case core::RoadKind::kSupportInterface:
      return {"a support", "set a smaller support_base_expansion, or move the part"};
    default:
      return {"a road", "move the part or set bed_x and bed_y"};
  }
}

core::Box grown(core::Box box, std::int64_t reach) {
  const auto by = static_cast<std::int32_t>(reach);
  if (box.empty()) return box;
  return {{box.min.x - by, box.min.y - by}, {box.max.x + by, box.max.y + by}};
}

}  // namespace

core::Status check_layer_height(const std::string& part, const core::Slice& slice,
                                const core::Settings& settings) {
  const auto refused = [&](const std::string& cause) {
    return core::Error{core::ErrorCode::kBadPart,
                       fmt::format("{}, layer {}: it is {:g} mm high, {}", part, slice.index + 1,
                                   slice.height.mm(), cause)};
  };
  if (slice.height * core::kWallLayersMax < settings.wall_thickness) {
    return refused(
        fmt::format("a wall of {:g} mm is more than {} such layers; make wall_thickness "
                    "less, or layers higher",
                    settings.wall_thickness.mm(), core::kWallLayersMax));
  }
  if (slice.height >= settings.road_width || slice.height > settings.nozzle_diameter) {
    return refused(
        fmt::format("more than road_width ({:g} mm) or nozzle_diameter ({:g} mm) "
                    "allows; is its unit right?",
                    settings.road_width.mm(), settings.nozzle_diameter.mm()));
  }
  return {};
}

core::Error no_road_fits(const std::string& part, const core::Settings& settings) {
  return {core::ErrorCode::kBadPart,
          fmt::format("{}: no road fits anywhere: at every height the part is narrower than "
                      "road_width_min ({:g} mm); is it in millimetres?",
                      part, settings.road_width_min.mm())};
}

core::Status check_on_bed(const std::string& part, const core::Slice& slice,
                          const std::vector<core::Road>& roads, const core::Settings& settings) {
  const core::Bed bed(settings);
  for (const core::Road& road : roads) {
    // An arc may bulge beyond its road's points; the nozzle must stay above the bed even then.
    const bool may_bulge =
        settings.arcs != core::ArcUse::kOff && road.points.size() >= core::kArcSegmentsMin;
    const std::int64_t bulge = may_bulge ? settings.arc_fit_tolerance.units() : 0;
    const std::int64_t reach = std::max(widest(road).units() / 2, bulge);
    if (bed.holds(grown(core::box_of(road.points), reach))) continue;
    for (const core::Point point : road.points) {
      if (bed.holds(point, core::Length::from_units(reach))) continue;
      const LeavingRoad leaving = leaving_road(road.kind);
      return core::Error{
          core::ErrorCode::kOutOfBounds,
          fmt::format(
              "{}, layer {}: {} at ({:.2f}, {:.2f}) mm leaves the bed of {:g} x {:g} mm{}; {}",
              part, slice.index + 1, leaving.name, core::Length::from_units(point.x).mm(),
              core::Length::from_units(point.y).mm(), settings.bed_x.mm(), settings.bed_y.mm(),
              settings.bed_shape.empty() ? "" : ", which is no rectangle (bed_shape)",
              leaving.remedy)};
    }
  }
  return {};
}

}  // namespace host
