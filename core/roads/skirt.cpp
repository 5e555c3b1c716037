#include "core/roads/skirt.h"

#include "core/offsets/slice_offsets.h"     // perimeter_spacing
#include "core/offsets/voronoi_mountain.h"  // offset

namespace core {

std::vector<Road> skirt_roads(const Region& slice, Length height, const Settings& settings) {
  std::vector<Road> roads;
  if (slice.empty()) return roads;
  const Length spacing = perimeter_spacing(settings, height);
  for (int loop = settings.skirt_loops - 1; loop >= 0; --loop) {
    const Length away = settings.skirt_distance +
                        Length::from_units(settings.road_width.units() / 2) + spacing * loop;
    const Region grown = offset(slice, -away, settings.arc_tolerance);
    for (const Ring& ring : grown.rings()) {
      if (doubled_area_units(ring) <= 0) continue;
      roads.push_back({RoadKind::kSkirt, settings.road_width, true, ring});
    }
  }
  return roads;
}

}  // namespace core
