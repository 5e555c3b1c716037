#include "core/booleans/simplified.h"

#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/regions/simplify.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"

using core::Length;
using core::Region;
using core::Ring;
using test::Random;

namespace {

std::vector<Ring> simple_rings(const Region& region, Length tolerance) {
  std::vector<Ring> rings;
  for (const Ring& ring : region.rings()) {
    Ring simple = core::simplify(ring, tolerance);
    if (simple.size() >= 3) rings.push_back(std::move(simple));
  }
  return rings;
}

}  // namespace

TEST_CASE("a simplified region is what clean() makes of its simplified rings, point by point") {
  int changed = 0, cut = 0;
  for (std::uint64_t seed = 1; seed <= 1'500; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region =
        seed % 2 == 0
            ? test::random_region(random, random.integer(3, 60), random.integer(2, 12))
            : core::unite(test::random_region(random, 40, 6), test::random_region(random, 50, 5));
    const Length tolerance = Length::from_units(random.integer(1, 4'000));
    const Region simple = core::simplified(region, tolerance);
    const std::vector<Ring> rings = simple_rings(region, tolerance);
    CHECK_EQ(simple, core::clean(rings, core::FillRule::kPositive));
    CHECK(test::is_clean(simple));
    changed += simple == region ? 0 : 1;
    cut += simple.point_count() == Region::from_clean_rings(rings).point_count() ? 0 : 1;
  }
  CHECK_GT(changed, 200);
  MESSAGE(cut << " were cut where they crossed");
}
