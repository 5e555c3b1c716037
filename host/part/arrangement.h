// Where several things lie on one bed.
//
// Each is a box. The largest comes first, into the bed's middle, and each of the others beside
// those that lie there already, as near to the middle as it can. If not all find a place so, they
// are put in rows from the front left corner. Things are not turned.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry.h"  // Point
#include "core/result.h"    // Result
#include "core/settings.h"  // Settings
#include "core/units.h"     // Length

namespace host {

struct Footprint {
  core::Length width;  // along x
  core::Length depth;  // along y
};

// How far the first layer reaches beyond the slice of what stands on it: brim, raft, supports.
[[nodiscard]] core::Length first_layer_reach(const core::Settings& settings);

// How far objects stay from one another: part_gap, or as far as two first layers reach. Where one
// is printed after another, the print head has room beside what is finished, too.
[[nodiscard]] core::Length object_gap(const core::Settings& settings);

// The front left corner of each, in the order given. Between any two there is object_gap(), beside
// each other or one behind the other. Where the settings centre the part, all of them together are
// in the middle of the bed if they can be, and leave room for first layer and skirt at its edges.
// Otherwise the corner of all of them is at part_x, part_y.
// Errors: kOutOfBounds if they do not fit; it says how many do.
// COSTS: O(n³) for n things. REQUIRES: 1 to kObjectsMax things.
[[nodiscard]] core::Result<std::vector<core::Point>> arranged(const std::vector<Footprint>& things,
                                                              const core::Settings& settings);

}  // namespace host
