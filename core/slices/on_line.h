// Segments that a plane cuts out of a mesh, by number, and which of them lie on one line.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>

namespace core {

// Where in the vector a segment came from; a gap that was closed came from nowhere.
using SegmentIndex = std::size_t;
inline constexpr SegmentIndex kNoSegment = std::numeric_limits<SegmentIndex>::max();

// Whether two segments lie on one straight line, whatever the rounding of their ends.
using OnOneLine = std::function<bool(SegmentIndex, SegmentIndex)>;

}  // namespace core
