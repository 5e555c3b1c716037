#include "host/part/moved_slice.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"  // intersect

namespace host {
namespace {

core::Point moved(core::Point point, const Shift& shift) {
  return {static_cast<std::int32_t>(point.x + shift.x),
          static_cast<std::int32_t>(point.y + shift.y)};
}

}  // namespace

core::Region moved(const core::Region& region, const Shift& shift) {
  std::vector<core::Ring> rings = region.rings();
  for (core::Ring& ring : rings) {
    for (core::Point& point : ring) point = moved(point, shift);
  }
  return core::Region::from_clean_rings(std::move(rings));
}

core::Region clipped(const core::Region& region, const core::Box& box) {
  core::Box both = box;
  both.add(region.box());
  if (both == box) return region;
  const core::Point min = box.min, max = box.max;
  return core::intersect(
      region, core::Region::from_clean_rings({{min, {max.x, min.y}, max, {min.x, max.y}}}));
}

core::SliceDefects moved(core::SliceDefects defects, const Shift& shift) {
  if (defects.turned_at) defects.turned_at = moved(*defects.turned_at, shift);
  return defects;
}

}  // namespace host
