#include "core/roads/boundary_ends.h"

#include <algorithm>
#include <numeric>

namespace core {

std::vector<BoundaryEnd> boundary_ends(const std::vector<ClippedLine>& lines,
                                       const LineClipper& clipper) {
  std::vector<BoundaryEnd> ends(lines.size() * 2);
  std::vector<std::size_t> order(ends.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const BoundaryPlace &p = place_of(lines, a), &q = place_of(lines, b);
    if (p.ring != q.ring) return p.ring < q.ring;
    return p.along != q.along ? p.along < q.along : a < b;
  });
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first;
    const std::size_t ring = place_of(lines, order[first]).ring;
    while (end < order.size() && place_of(lines, order[end]).ring == ring) ++end;
    for (std::size_t i = first; i < end; ++i) {
      const std::size_t a = order[i], b = order[i + 1 < end ? i + 1 : first];
      ends[a].next = b;
      ends[b].before = a;
      ends[a].way = place_of(lines, b).along - place_of(lines, a).along;
      if (i + 1 == end) ends[a].way += clipper.ring_length(ring);
    }
    first = end;
  }
  return ends;
}

void append_line(const ClippedLine& line, bool from_its_begin, std::vector<Point>& points) {
  if (from_its_begin) {
    points.insert(points.end(), line.points.begin(), line.points.end());
  } else {
    points.insert(points.end(), line.points.rbegin(), line.points.rend());
  }
}

}  // namespace core
