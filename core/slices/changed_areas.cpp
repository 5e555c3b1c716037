#include "core/slices/changed_areas.h"

#include <algorithm>
#include <utility>

#include "core/booleans/boolean.h"  // intersect, subtract, unite

namespace core {

bool AreaChange::lays_otherwise() const {
  return std::any_of(laid.begin(), laid.end(), [](const auto& value) { return value.has_value(); });
}

AreaChange merged(const AreaChange& earlier, const AreaChange& later) {
  AreaChange both = later;
  if (!both.density) both.density = earlier.density;
  if (!both.pattern) both.pattern = earlier.pattern;
  if (!both.perimeters) both.perimeters = earlier.perimeters;
  for (std::size_t i = 0; i < both.laid.size(); ++i) {
    if (!both.laid[i]) both.laid[i] = earlier.laid[i];
  }
  return both;
}

ChangedAreas parted(const ChangedAreas& areas) {
  ChangedAreas parts;
  for (const ChangedArea& area : areas) {
    Region rest = area.region;
    const Box box = rest.box();
    for (std::size_t i = 0, before = parts.size(); i < before; ++i) {
      if (rest.empty() || !parts[i].region.box().overlaps(box)) continue;
      Region common = intersect(parts[i].region, rest);
      if (common.empty()) continue;
      rest = subtract(rest, common);
      const AreaChange both = merged(parts[i].change, area.change);
      if (both == parts[i].change) continue;
      parts[i].region = subtract(parts[i].region, common);
      parts.push_back({both, std::move(common)});
    }
    if (!rest.empty()) parts.push_back({area.change, std::move(rest)});
  }
  ChangedAreas joined;
  for (ChangedArea& part : parts) {
    if (part.region.empty()) continue;
    const auto same = std::find_if(joined.begin(), joined.end(), [&](const ChangedArea& other) {
      return other.change == part.change;
    });
    if (same == joined.end()) {
      joined.push_back(std::move(part));
    } else {
      same->region = unite(same->region, part.region);
    }
  }
  return joined;
}

}  // namespace core
