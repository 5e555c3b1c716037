// Checks roads by sampling, independent of the code that plans them.
#pragma once

#include <vector>

#include "core/regions/region.h"           // Region
#include "core/roads/road.h"               // Road
#include "core/units.h"                    // Length
#include "tests/support/random_regions.h"  // Random

namespace test {

// Fraction of the region's random points within half a road's width of its centre line.
double covered_share(const core::Region& region, const std::vector<core::Road>& roads, int points,
                     Random& random);

// Largest distance in mm that the beads stick out of the region.
double sticks_out_mm(const core::Region& region, const std::vector<core::Road>& roads);

// Least distance in mm of any centre line's points from the region's contour; negative outside.
double least_depth_mm(const core::Region& region, const std::vector<core::Road>& roads);

// Volume laid over the layer's height.
double laid_mm2(const std::vector<core::Road>& roads, core::Length height);

double total_length_mm(const std::vector<core::Road>& roads);

}  // namespace test
