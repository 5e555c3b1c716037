#include "core/roads/solid_areas.h"

#include <memory>
#include <utility>

#include "core/booleans/boolean.h"         // intersect, subtract
#include "core/booleans/simplified.h"      // simplified
#include "core/offsets/offset_contours.h"  // flatten
#include "core/offsets/polygon_offset.h"   // PolygonOffsetter

namespace core {
namespace {

// What of the wall the neighbour leaves open, where that is wide enough.
Region open_to(const Region& wall, const SplitLayer& layer,
               const std::shared_ptr<const Region>& neighbour, const Settings& settings) {
  if (!neighbour) return wall;
  if (*neighbour == layer.slice.region) return {};
  const Region open = subtract(wall, *neighbour);
  if (open.empty()) return {};
  const Length half = Length::from_mm(settings.road_width.mm() * kTopRoadsMin / 2);
  PolygonOffsetter offsetter;
  const Region middle = flatten(offsetter.offset(open, half), settings.arc_tolerance);
  if (middle.empty()) return {};
  const Length back = Length() - half * 2;
  const Region grown =
      flatten(offsetter.offset(simplified(middle, settings.simplify_tolerance), back),
              settings.arc_tolerance);
  return intersect(wall, grown);
}

}  // namespace

SolidAreas solid_areas(Region wall, const SplitLayer& layer, const Settings& settings) {
  SolidAreas areas;
  areas.between = std::move(wall);
  if (areas.between.empty()) return areas;
  areas.top = open_to(areas.between, layer, layer.above, settings);
  if (!areas.top.empty()) areas.between = subtract(areas.between, areas.top);
  if (areas.between.empty()) return areas;
  areas.bottom = open_to(areas.between, layer, layer.below, settings);
  if (!areas.bottom.empty()) areas.between = subtract(areas.between, areas.bottom);
  return areas;
}

}  // namespace core
