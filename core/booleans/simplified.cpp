#include "core/booleans/simplified.h"

#include <utility>
#include <vector>

#include "core/booleans/boolean.h"       // clean
#include "core/booleans/ring_tracer.h"   // sort_rings
#include "core/regions/contact_check.h"  // surely_clean
#include "core/regions/simplify.h"       // simplify

namespace core {
namespace {

// A corner at which the ring runs straight on, which clean() leaves out.
bool has_straight_corner(const Ring& ring) {
  Point before = ring[ring.size() - 2], at = ring.back();
  for (const Point after : ring) {
    if (cross(before, at, after) == 0) return true;
    before = at;
    at = after;
  }
  return false;
}

}  // namespace

Region simplified(const Region& region, Length tolerance) {
  std::vector<Ring> rings;
  rings.reserve(region.rings().size());
  bool straight = false;
  for (const Ring& ring : region.rings()) {
    Ring simple = simplify(ring, tolerance);
    if (simple.size() < 3) continue;
    straight = straight || has_straight_corner(simple);
    rings.push_back(std::move(simple));
  }
  // As a rule nothing has come to touch, and simplify() starts rings where clean() does.
  if (straight || !surely_clean(rings)) return clean(rings, FillRule::kPositive);
  sort_rings(rings);
  return Region::from_clean_rings(std::move(rings));
}

}  // namespace core
