// The rings of a sound mesh: the fast case of segment_chains.h.
//
// There, every point at which a segment ends is the start of exactly one, so segments are found by
// their starts in a hash table, and nothing has to be decided.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry.h"        // Ring, Segment
#include "core/slices/on_line.h"  // OnOneLine

namespace core {

// The same rings as rings_of() gives, in the same order and from the same points; nullopt where
// some point has more or fewer than one segment that comes and one that leaves, or where a segment
// and its reverse make a ring. Segments from a point to itself don't count.
//
// Each thread keeps the memory that this needs on the way; the rings alone are allocated.
// COSTS: O(n), and a sort of the rings by their least points.
[[nodiscard]] std::optional<std::vector<Ring>> sound_rings(const std::vector<Segment>& segments,
                                                           const OnOneLine& on_one_line);

}  // namespace core
