#include "core/roads/pin_rings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "core/offsets/offset_contours.h"  // flatten
#include "core/offsets/polygon_offset.h"   // PolygonOffsetter
#include "core/offsets/slice_offsets.h"    // perimeter_spacing
#include "core/regions/simplify.h"         // simplify
#include "core/roads/beading.h"            // kRoomSlack

namespace core {
namespace {

// perimeter² / (4 π area) is 1 for a disc, 1.27 for a square, 1.65 for a triangle.
constexpr double kRoundMax = 1.4;

// The largest disc of a pin has at least this share of the radius that its contour would have if it
// touched it all around.
constexpr double kDiscShareMin = 0.97;

Region inset(const Region& region, double depth_mm, const Settings& settings) {
  return flatten(PolygonOffsetter().offset(region, Length::from_mm(depth_mm)),
                 settings.arc_tolerance);
}

}  // namespace

std::optional<std::vector<Road>> pin_rings(const Region& island, Length height,
                                           const Settings& settings) {
  const double spacing_mm = perimeter_spacing(settings, height).mm();
  const double rim_mm = settings.road_width.mm() - spacing_mm;
  const Box box = island.box();
  const std::int64_t side =
      std::max(std::int64_t{box.max.x} - box.min.x, std::int64_t{box.max.y} - box.min.y);
  // No pin with rings of that number is as large.
  if (island.rings().size() != 1 ||
      Length::from_units(side).mm() > 4 * (settings.perimeters + 1) * spacing_mm)
    return {};
  const double area = island.area_mm2(), perimeter = island.perimeter_mm();
  if (perimeter * perimeter > kRoundMax * 4 * std::numbers::pi * area) return {};
  const double radius = 2 * area / perimeter, room = radius - rim_mm / 2;
  const auto count = std::max(1L, std::lround(room / spacing_mm));
  const double share = room / static_cast<double>(count);
  const Length width = Length::from_mm(share + rim_mm);
  if (count > settings.perimeters || width < settings.road_width_min - kRoomSlack) return {};
  if (inset(island, kDiscShareMin * radius, settings).empty()) return {};
  std::vector<Road> roads;
  for (long number = 0; number < count; ++number) {
    const double depth = width.mm() / 2 + share * static_cast<double>(number);
    const Region line = inset(island, depth, settings);
    if (line.rings().size() != 1) return {};
    Ring ring = simplify(line.rings().front(), settings.arc_tolerance);
    if (ring.size() < 3) return {};
    const RoadKind kind = number == 0 ? RoadKind::kOuterPerimeter : RoadKind::kPerimeter;
    roads.push_back({kind, width, true, std::move(ring)});
  }
  return roads;
}

}  // namespace core
