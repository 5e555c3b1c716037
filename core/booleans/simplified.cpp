#include "core/booleans/simplified.h"

#include <utility>
#include <vector>

#include "core/booleans/boolean.h"  // clean
#include "core/regions/simplify.h"  // simplify

namespace core {

Region simplified(const Region& region, Length tolerance) {
  std::vector<Ring> rings;
  for (const Ring& ring : region.rings()) {
    Ring simple = simplify(ring, tolerance);
    if (simple.size() >= 3) rings.push_back(std::move(simple));
  }
  return clean(rings, FillRule::kPositive);
}

}  // namespace core
