#include "core/offsets/offset_runs.h"

namespace core {
namespace {

// An edge that keeps less than this, units, ends a run: rounding decides nothing.
constexpr double kRemainderMin = 1e-3;

double turn(const OffsetEdge& a, const OffsetEdge& b) {
  return exact_cross<true>(a.dx, a.dy, b.dx, b.dy);
}

// True when the contour first … last - 1 is a run as a whole.
bool turns_one_way(const OffsetInput& contours, std::size_t first, std::size_t last,
                   double deepest) {
  const bool right = contours.corners()[first].reflex;
  for (std::size_t i = first; i < last; ++i) {
    const OffsetCorner& corner = contours.corners()[i];
    if (corner.reflex != right) return false;
    if (right) continue;
    const OffsetEdge& edge = contours.edges()[i];
    const OffsetCorner& end = contours.corners()[static_cast<std::size_t>(edge.end_corner)];
    if (edge.length - deepest * (corner.half_tangent + end.half_tangent) < kRemainderMin) {
      return false;
    }
  }
  return true;
}

void mark_chains(OffsetInput& contours, std::size_t first, std::size_t last, double deepest) {
  std::vector<OffsetEdge>& edges = contours.edges_to_mark();
  std::size_t left = first, right = first;  // the chain's directions turned farthest
  double remainder = edges[first].length;
  std::int32_t run = static_cast<std::int32_t>(first);
  edges[first].run = run;
  for (std::size_t i = first + 1; i < last; ++i) {
    OffsetEdge& edge = edges[i];
    const double from_left = turn(edges[left], edge), from_right = turn(edges[right], edge);
    bool goes_on = true;
    if (from_left > 0) {
      goes_on = from_right > 0;
      left = i;
    } else if (from_right < 0) {
      goes_on = from_left < 0;
      right = i;
    } else {
      // Within the wedge, or opposite to one of its sides.
      goes_on = from_left < 0 || from_right > 0 ||
                exact_dot<true>(edges[left].dx, edges[left].dy, edge.dx, edge.dy) > 0;
    }
    const OffsetCorner& corner = contours.corners()[i];
    const double cut = corner.reflex ? 0 : deepest * corner.half_tangent;
    goes_on = goes_on && remainder - cut >= kRemainderMin && edge.length - cut >= kRemainderMin;
    if (goes_on) {
      remainder = edge.length - cut;
    } else {
      run = static_cast<std::int32_t>(i);
      left = right = i;
      remainder = edge.length;
    }
    edge.run = run;
  }
}

}  // namespace

void find_runs(OffsetInput& contours, double deepest) {
  std::vector<OffsetEdge>& edges = contours.edges_to_mark();
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t last = first + 1;
    while (last < edges.size() && edges[last - 1].end_corner == static_cast<std::int32_t>(last)) {
      ++last;
    }
    if (contours.mended()) {
      for (std::size_t i = first; i < last; ++i) edges[i].run = static_cast<std::int32_t>(i);
    } else if (turns_one_way(contours, first, last, deepest)) {
      for (std::size_t i = first; i < last; ++i) edges[i].run = static_cast<std::int32_t>(first);
    } else {
      mark_chains(contours, first, last, deepest);
    }
    first = last;
  }
}

}  // namespace core
