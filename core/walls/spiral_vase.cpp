#include "core/walls/spiral_vase.h"

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

}  // namespace core
