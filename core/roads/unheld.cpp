#include "core/roads/unheld.h"

#include <utility>

#include "core/booleans/boolean.h"           // intersect, subtract
#include "core/booleans/simplified.h"        // simplified
#include "core/offsets/voronoi_mountain.h"   // offset
#include "core/regions/contour_proximity.h"  // frechet_within
#include "core/roads/bridge_rows.h"          // rings_near

namespace core {
namespace {

// Hairs narrower than this are rounding.
constexpr double kHairMm = 0.02;

}  // namespace

Region unheld(const Region& slice, const Region& below, Length reach) {
  // On the straight ways between the two walkers a slice passes over all that it gains. One walk
  // may leave out a piece of the other contour, near its start.
  if (frechet_within(slice, below, reach) && frechet_within(below, slice, reach)) return {};
  const Region gained = subtract(slice, below);
  if (gained.empty()) return {};
  return subtract(gained, offset(simplified(below, kUnheldTolerance), -reach, kUnheldTolerance));
}

std::vector<Region> islands_in_air(const Region& slice, const Region& below) {
  std::vector<Region> begun;
  for (Island& island : islands(slice)) {
    Region whole = region_of(std::move(island));
    if (intersect(whole, rings_near(below, whole.box())).empty()) begun.push_back(std::move(whole));
  }
  return begun;
}

bool is_hair(const Region& piece) { return 2 * piece.area_mm2() < kHairMm * piece.perimeter_mm(); }

}  // namespace core
