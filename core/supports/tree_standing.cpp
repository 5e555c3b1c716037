#include "core/supports/tree_standing.h"

#include "core/booleans/boolean.h"           // intersect, subtract, unite
#include "core/offsets/voronoi_mountain.h"   // offset
#include "core/regions/contour_proximity.h"  // stays_near
#include "core/supports/support_regions.h"   // kSupportTolerance, shared

namespace core {
namespace {

// Radii are laid in steps of this, and what is laid is exact to less.
constexpr Length kLaidSlack = Length::from_units(600);
// How far apart the places of a contour are that are looked at.
constexpr Length kSampled = Length::from_units(500);
}  // namespace

Length branch_overhang(Length step) { return step * 2 + kLaidSlack; }

SupportLayer TreeStanding::standing(const SupportLayer& layer) {
  SupportLayer result = layer;
  if (below_ && layer.branches && !layer.branches->empty()) result = trimmed(layer);
  below_ = result.region;
  return result;
}

SupportLayer TreeStanding::trimmed(const SupportLayer& layer) const {
  const Length reach = branch_overhang(layer.step);
  if (layer.branches == below_ || stays_near(*layer.branches, *below_, reach, kSampled))
    return layer;
  Region ground = offset(*below_, -reach, kSupportTolerance);
  if (layer.feet) ground = unite(ground, *layer.feet);
  const Region lobes = subtract(*layer.branches, ground);
  if (lobes.empty()) return layer;
  SupportLayer result = layer;
  result.branches = shared(subtract(*layer.branches, lobes));
  result.region = shared(subtract(*layer.region, lobes));
  result.interface = shared(intersect(*layer.interface, *result.region));
  return result;
}

}  // namespace core
