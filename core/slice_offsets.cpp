#include "core/slice_offsets.h"

#include <numbers>

#include "core/offset_contours.h"   // flatten
#include "core/voronoi_mountain.h"  // VoronoiMountain

namespace core {

Length perimeter_spacing(const Settings& settings, Length layer_height) {
  const double void_mm = layer_height.mm() * (1 - std::numbers::pi / 4);
  return Length::from_mm(settings.road_width.mm() - settings.road_overlap * void_mm);
}

Length perimeter_depth(const Settings& settings, Length layer_height, int number) {
  const Length s = perimeter_spacing(settings, layer_height);
  return Length::from_units(settings.road_width.units() / 2) + s * (number - 1);
}

Length narrow_half(const Settings& settings, Length layer_height) {
  return Length::from_mm(kNarrowShare / 2 * perimeter_spacing(settings, layer_height).mm());
}

SliceOffsets slice_offsets(const Slice& slice, const Settings& settings, OffsetCounters& counters) {
  SliceOffsets cut;
  if (slice.region.empty()) return cut;
  const VoronoiMountain mountain(slice.region);
  ++counters.mountains;
  counters.retries += mountain.retries();
  const auto at = [&](Length depth) {
    return flatten(mountain.offset(depth), settings.arc_tolerance);
  };
  const Length half_spacing =
      Length::from_units(perimeter_spacing(settings, slice.height).units() / 2);
  const Length half_narrow = narrow_half(settings, slice.height);
  cut.wall_inner = at(settings.wall_thickness);
  Length inner_edge;
  for (int number = 1; number <= settings.perimeters; ++number) {
    const Length depth = perimeter_depth(settings, slice.height, number);
    cut.perimeters.push_back(mountain.offset(depth));
    cut.perimeter_cores.push_back(at(depth + half_narrow));
    inner_edge = depth + half_spacing;
  }
  cut.interior = inner_edge == Length() ? slice.region : at(inner_edge);
  return cut;
}

}  // namespace core
