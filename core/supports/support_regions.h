// What the folds of supports do with regions, and how exactly.
#pragma once

#include <memory>
#include <utility>

#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/regions/region.h"            // Region
#include "core/supports/support_fold.h"     // SharedRegion
#include "core/units.h"                     // Length

namespace core {

// What is laid is simplified and offset this exactly.
inline constexpr Length kSupportTolerance = Length::from_units(200);

[[nodiscard]] inline SharedRegion shared(Region region) {
  return std::make_shared<const Region>(std::move(region));
}

[[nodiscard]] inline Length scaled(Length length, double factor) {
  return Length::from_mm(length.mm() * factor);
}

// Outwards; the region itself if `by` is not positive. COSTS: an offset.
[[nodiscard]] inline Region grown(const Region& region, Length by) {
  if (region.empty() || by <= Length()) return region;
  return offset(region, -by, kSupportTolerance);
}

}  // namespace core
