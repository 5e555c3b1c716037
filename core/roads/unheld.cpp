#include "core/roads/unheld.h"

#include "core/booleans/boolean.h"           // subtract
#include "core/booleans/simplified.h"        // simplified
#include "core/offsets/voronoi_mountain.h"   // offset
#include "core/regions/contour_proximity.h"  // frechet_within

namespace core {

Region unheld(const Region& slice, const Region& below, Length reach) {
  // On the straight ways between the two walkers a slice passes over all that it gains. One walk
  // may leave out a piece of the other contour, near its start.
  if (frechet_within(slice, below, reach) && frechet_within(below, slice, reach)) return {};
  const Region gained = subtract(slice, below);
  if (gained.empty()) return {};
  return subtract(gained, offset(simplified(below, kUnheldTolerance), -reach, kUnheldTolerance));
}

}  // namespace core
