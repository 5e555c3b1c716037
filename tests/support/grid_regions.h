// Small clean regions with many coincidences: corners are on a grid of at most 17 x 17 points, so
// that edges line up, contours touch, walls are parallel, and distances are often equal.
#pragma once

#include <cstdint>

#include "core/regions/region.h"           // Region
#include "tests/support/random_regions.h"  // Random

namespace test {

// Grid steps are `scale` units. Of two kinds: unions of grid cells and half cells (everything at
// 45°, contours touch at corners all over), and random rings kept when they happen to be clean (any
// angle, corners on edges, needles); turned, mirrored or shifted far off by chance.
core::Region random_grid_region(Random& random, int scale);

}  // namespace test
