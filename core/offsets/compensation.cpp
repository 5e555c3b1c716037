#include "core/offsets/compensation.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"          // clean, subtract, unite
#include "core/offsets/voronoi_mountain.h"  // offset

namespace core {

namespace {

// A place is lost to an offset there and back by more than rounding takes.
constexpr Length kRounding = Length::from_units(10);

void append_offset(Ring ring, Length outwards, Length arc_tolerance, std::vector<Ring>& rings) {
  const Region grown =
      offset(Region::from_clean_rings({std::move(ring)}), -outwards, arc_tolerance);
  rings.insert(rings.end(), grown.rings().begin(), grown.rings().end());
}

// Outer contours and holes by different lengths.
Region moved(const Region& region, const Settings& settings) {
  const Length contours = settings.contour_compensation, holes = settings.hole_compensation;
  if (contours == holes) return offset(region, -contours, settings.arc_tolerance);
  std::vector<Ring> all;
  for (Island& island : islands(region)) {
    std::vector<Ring> outer, inner;
    append_offset(std::move(island.outer), contours, settings.arc_tolerance, outer);
    for (Ring& hole : island.holes) {
      std::reverse(hole.begin(), hole.end());
      append_offset(std::move(hole), -holes, settings.arc_tolerance, inner);
    }
    const Region built =
        subtract(clean(outer, FillRule::kNonZero), clean(inner, FillRule::kNonZero));
    all.insert(all.end(), built.rings().begin(), built.rings().end());
  }
  return clean(all, FillRule::kNonZero);
}

// Smaller by `inset`, but for what would get narrower than `narrowest`.
Region shrunk(const Region& region, Length inset, Length narrowest, Length arc_tolerance) {
  const Length half = Length::from_units(narrowest.units() / 2);
  const Region wide = offset(offset(region, inset + half, arc_tolerance),
                             -(inset + half + kRounding), arc_tolerance);
  const Region narrow = subtract(region, wide);
  return unite(offset(region, inset, arc_tolerance), narrow);
}

}  // namespace

bool compensates(const Settings& settings) {
  return settings.contour_compensation != Length() || settings.hole_compensation != Length() ||
         settings.elephant_foot_compensation > Length();
}

Region compensated(const Slice& slice, const Settings& settings) {
  Region region = slice.region;
  const bool moves =
      settings.contour_compensation != Length() || settings.hole_compensation != Length();
  if (moves && !region.empty()) region = moved(region, settings);
  if (slice.index == 0 && settings.elephant_foot_compensation > Length() && !region.empty()) {
    region = shrunk(region, settings.elephant_foot_compensation, settings.road_width,
                    settings.arc_tolerance);
  }
  return region;
}

}  // namespace core
