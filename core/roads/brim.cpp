#include "core/roads/brim.h"

#include <algorithm>
#include <cmath>

#include "core/offsets/slice_offsets.h"     // perimeter_spacing
#include "core/offsets/voronoi_mountain.h"  // offset

namespace core {

namespace {

bool wanted(const Ring& ring, BrimPlace place) {
  const bool outer = doubled_area_units(ring) > 0;
  return place == BrimPlace::kBoth || outer == (place == BrimPlace::kOuter);
}

}  // namespace

Length brim_reach(const Settings& settings) {
  if (settings.brim_width <= Length() || settings.brim_place == BrimPlace::kInner) return {};
  return settings.brim_gap + settings.brim_width;
}

std::vector<Road> brim_roads(const Region& slice, Length height, const Settings& settings) {
  std::vector<Road> roads;
  if (slice.empty() || settings.brim_width <= Length()) return roads;
  const Length spacing = perimeter_spacing(settings, height);
  const int loops = std::max(1, static_cast<int>(settings.brim_width.units() / spacing.units()));
  for (int loop = loops - 1; loop >= 0; --loop) {
    const Length away =
        settings.brim_gap + Length::from_units(settings.road_width.units() / 2) + spacing * loop;
    const Region grown = offset(slice, -away, settings.arc_tolerance);
    for (const Ring& ring : grown.rings()) {
      if (!wanted(ring, settings.brim_place)) continue;
      roads.push_back({RoadKind::kBrim, settings.road_width, true, ring});
    }
  }
  return roads;
}

}  // namespace core
