// The ends of clipped lines in their order along the contours.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry.h"         // Point
#include "core/roads/line_clip.h"  // BoundaryPlace, ClippedLine, LineClipper

namespace core {

// Ends are numbered: 2 i where line i begins, 2 i + 1 where it ends. So end ^ 1 is the line's other
// end.
struct BoundaryEnd {
  std::size_t next = 0, before = 0;  // ends: the neighbours along the ring, at least itself
  double way = 0;                    // to the next, in units
};

// COSTS: O(ends · log).
[[nodiscard]] std::vector<BoundaryEnd> boundary_ends(const std::vector<ClippedLine>& lines,
                                                     const LineClipper& clipper);

[[nodiscard]] inline const BoundaryPlace& place_of(const std::vector<ClippedLine>& lines,
                                                   std::size_t end) {
  return end % 2 == 0 ? lines[end / 2].from : lines[end / 2].to;
}

// Appends a line's points, from the end given on.
void append_line(const ClippedLine& line, bool from_its_begin, std::vector<Point>& points);

}  // namespace core
