// How tests look at offsets: by measured distances, and beside the whole diagram.
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

// What chords may stay away from arcs.
inline const core::Length kArcTolerance = core::Length::from_mm(0.0025);
// Ends are rounded to the grid, ours and the reference's.
inline constexpr double kOffsetRoundingUnits = 2;

// Every piece lies at its depth, its start and its middle: the worst error in units.
double worst_depth_error(const core::Region& region, core::Length depth,
                         const core::OffsetContours& contours);

// Of `samples` random points, how many lie inside the result and aren't deep enough, or outside
// and are; points nearer to the depth than tolerance and rounding aren't asked.
int misjudged_points(const core::Region& region, core::Length depth, const core::Region& result,
                     Random& random, int samples, core::Length tolerance = kArcTolerance);

// Depths at which small regions on a grid of `scale` units are critical: its multiples, and roots.
core::Length random_grid_depth(Random& random, int scale);

// What comparisons with the whole diagram found, in units.
struct OffsetComparison {
  std::int64_t compared = 0;
  std::int64_t critical = 0;  // farther apart, because the depth is critical: see below
  double farthest = 0;        // of small regions that were not
};

// Offsets beside those that a whole diagram gives: Hausdorff distance of the contours at most
// kOffsetRoundingUnits and the tolerance. Where it is more, ours must hold what is that much
// deeper than the depth, and lie within what is that much less deep: at critical depths parts that
// are nowhere wider than that are in the one and not in the other. Ours must be clean.
// Returns what was wrong, or nothing.
std::string check_against_diagram(core::PolygonOffsetter& offsetter, const core::Region& region,
                                  std::span<const core::Length> depths,
                                  OffsetComparison& comparison);

// One case out of any bytes, for the fuzzer and for random tests: rings on a coarse grid, cleaned,
// and a depth; pieces at their depth, points judged rightly, a clean result, three depths together
// as each alone. Returns what was wrong, or nothing.
std::string check_offset_case(std::span<const std::uint8_t> bytes);

}  // namespace test
