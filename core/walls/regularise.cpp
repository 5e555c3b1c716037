#include "core/walls/regularise.h"

#include <utility>
#include <vector>

#include "core/booleans/boolean.h"      // subtract
#include "core/booleans/ring_tracer.h"  // sort_rings
#include "core/check.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/regions/contour_proximity.h"

namespace core {
namespace {

// A corner of angle α is r / sin(α/2) from what is wide enough: one of 74° or more is nearer than
// this many radii. A tongue's tip is farther, unless it is no longer than such a corner.
constexpr double kCornerReach = 1.66;
// How near to one another the contour's samples are.
constexpr double kSampleShare = 0.25;

double island_area_mm2(const Island& island) {
  double doubled_units = doubled_area_units(island.outer);
  for (const Ring& hole : island.holes) doubled_units += doubled_area_units(hole);
  return doubled_units / 2 / (kUnitsPerMm * kUnitsPerMm);
}

// Opening by a disc of radius r takes r² (cot(α/2) − (π − α)/2) off a corner of angle α: 0.21 r² at
// 90°, 1.6 r² at 40°. What is larger is a tongue.
bool is_corner_bit(const Island& island, Length radius) {
  return island_area_mm2(island) <= 1.6 * radius.mm() * radius.mm();
}

Region without_small_islands(const Region& region, double area_min_mm2) {
  std::vector<Ring> kept;
  for (Island& island : islands(region)) {
    if (island_area_mm2(island) < area_min_mm2) continue;
    append_rings(std::move(island), kept);
  }
  return Region::from_clean_rings(std::move(kept));
}

// Adds what is left of an island without its tongues. What holds no disc is one as a whole.
void add_without_tongues(Region island, Length radius, Length arc_tolerance,
                         std::vector<Ring>& rest) {
  const Region core = offset(island, radius, arc_tolerance, ArcForm::kBothSides);
  if (core.empty()) return;
  const Length reach = Length::from_mm(kCornerReach * radius.mm());
  std::vector<Ring> tongues;
  if (!stays_near(island, core, reach, Length::from_mm(kSampleShare * reach.mm()))) {
    // Grown by a hair more than it was shrunk, so that only tongues and corners are left.
    const Region opened =
        offset(core, -radius - arc_tolerance * 2, arc_tolerance, ArcForm::kBothSides);
    for (Island& lost : islands(subtract(island, opened))) {
      if (!is_corner_bit(lost, radius)) append_rings(std::move(lost), tongues);
    }
  }
  if (!tongues.empty()) island = subtract(island, Region::from_clean_rings(std::move(tongues)));
  rest.insert(rest.end(), island.rings().begin(), island.rings().end());
}

Region without_tongues(const Region& loose, Length width_min, Length arc_tolerance) {
  const Length radius = Length::from_units(width_min.units() / 2);
  std::vector<Ring> rest;
  for (Island& island : islands(loose)) {
    add_without_tongues(region_of(std::move(island)), radius, arc_tolerance, rest);
  }
  sort_rings(rest);
  return Region::from_clean_rings(std::move(rest));
}

}  // namespace

RegulariseOptions regularise_options(const Settings& settings) {
  return {settings.loose_width_min, settings.loose_area_min_mm2, settings.arc_tolerance};
}

Region regularise_loose(const Region& loose, const RegulariseOptions& options) {
  RIND_CHECK(options.width_min >= Length() && options.area_min_mm2 >= 0);
  RIND_CHECK(options.arc_tolerance > Length());
  if (loose.empty()) return {};
  const Region wide = options.width_min > Length()
                          ? without_tongues(loose, options.width_min, options.arc_tolerance)
                          : loose;
  return without_small_islands(wide, options.area_min_mm2);
}

}  // namespace core
