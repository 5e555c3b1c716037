// What Clipper2 does with slices, for tools/bench_kernels. It is no part of the project: where
// CMake has not found it, nothing of it is built.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace clipper2 {

// Whether it is built in. REQUIRES of all that follow: it is.
[[nodiscard]] bool found();

// Each makes a call that does the same to all of the regions, and returns how many rings came out.
using Call = std::function<std::size_t()>;
using RegionPairs = std::vector<std::pair<core::Region, core::Region>>;

// Inwards. The regions are copied, as Clipper2 wants them.
[[nodiscard]] Call offsets(const std::vector<core::Region>& regions, core::Length depth,
                           core::Length tolerance);
[[nodiscard]] Call intersections(const RegionPairs& pairs);
[[nodiscard]] Call differences(const RegionPairs& pairs);

}  // namespace clipper2
