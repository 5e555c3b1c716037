#include "core/walls/spiral_vase.h"

#include "core/booleans/boolean.h"          // subtract_within
#include "core/offsets/voronoi_mountain.h"  // offset

namespace core {

Region largest_contour(const Region& region) {
  const Ring* largest = nullptr;
  double most = 0;
  for (const Ring& ring : region.rings()) {
    const double area = doubled_area_units(ring);
    if (area <= most) continue;
    most = area;
    largest = &ring;
  }
  return largest == nullptr ? Region() : Region::from_clean_rings({*largest});
}

Region vase_ring(const Region& slice, const Settings& settings) {
  return subtract_within(slice, offset(slice, settings.road_width, settings.arc_tolerance));
}

}  // namespace core
