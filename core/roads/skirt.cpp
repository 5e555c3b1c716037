#include "core/roads/skirt.h"

#include <algorithm>

#include "core/offsets/slice_offsets.h"     // perimeter_spacing
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/roads/brim.h"                // brim_reach

namespace core {

std::vector<Road> skirt_roads(const Region& slice, Length height, const Settings& settings) {
  std::vector<Road> roads;
  if (slice.empty() || settings.skirt_loops == 0) return roads;
  const Length spacing = perimeter_spacing(settings, height);
  const Length nearest = brim_reach(settings) + settings.skirt_distance +
                         Length::from_units(settings.road_width.units() / 2);
  double laid_mm = 0;
  for (int loop = 0; loop < kSkirtLoopsMax; ++loop) {
    if (loop >= settings.skirt_loops && laid_mm >= settings.skirt_length_min.mm()) break;
    const Region grown = offset(slice, -(nearest + spacing * loop), settings.arc_tolerance);
    for (const Ring& ring : grown.rings()) {
      if (doubled_area_units(ring) <= 0) continue;
      roads.push_back({RoadKind::kSkirt, settings.road_width, true, ring});
      laid_mm += length_mm(roads.back());
    }
  }
  std::reverse(roads.begin(), roads.end());
  return roads;
}

}  // namespace core
