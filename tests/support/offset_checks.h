// Checks offsets by measured distances, and against those from the whole diagram.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/offsets/offset_contours.h"  // OffsetContours
#include "core/offsets/polygon_offset.h"   // PolygonOffsetter
#include "core/regions/region.h"           // Region
#include "core/units.h"                    // Length
#include "tests/support/random_regions.h"  // Random

namespace test {

// Tolerance of chords for arcs.
inline const core::Length kArcTolerance = core::Length::from_mm(0.0025);
// Ends are rounded to the grid, both ours and the reference's.
inline constexpr double kOffsetRoundingUnits = 2;

// The worst error, in units, of the depth of the pieces' starts and middles.
double worst_depth_error(const core::Region& region, core::Length depth,
                         const core::OffsetContours& contours);

// How many of `samples` random points are inside the result but not deep enough, or outside but
// deep enough. Points nearer to the depth than tolerance and rounding don't count.
int misjudged_points(const core::Region& region, core::Length depth, const core::Region& result,
                     Random& random, int samples, core::Length tolerance = kArcTolerance);

// Depths that are critical for small regions on a grid of `scale` units: its multiples, and roots.
core::Length random_grid_depth(Random& random, int scale);

// Results of comparisons with the whole diagram, in units.
struct OffsetComparison {
  std::int64_t compared = 0;
  std::int64_t critical = 0;  // farther apart, because the depth is critical: see below
  double farthest = 0;        // of small regions that were not
};

// Compares offsets with those of a whole diagram. The Hausdorff distance of the contours may be at
// most kOffsetRoundingUnits plus the tolerance. If it is more, ours must contain the offset that is
// deeper by that much and lie within the one that is less deep: at critical depths, pieces narrower
// than that may be in only one of the two. Ours must be clean.
// Returns what was wrong; empty if nothing.
std::string check_against_diagram(core::PolygonOffsetter& offsetter, const core::Region& region,
                                  std::span<const core::Length> depths,
                                  OffsetComparison& comparison);

// Makes a case from any bytes, for the fuzzer and for random tests: cleaned rings on a coarse grid,
// and a depth. Checks that pieces are at their depth, that points are on the right side, that the
// result is clean, and that three depths together give the same as each alone. Returns what was
// wrong; empty if nothing.
std::string check_offset_case(std::span<const std::uint8_t> bytes);

}  // namespace test
