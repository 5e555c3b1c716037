// Trims every offset element of a region's contours at one depth d. Of an edge's line and of a
// reflex corner's arc, only the points stay that no capsule covers.
//
// Each other edge f cuts one interval out of an element, because its capsule (all points nearer
// than d) is convex. The ends of the interval are known in closed form. For the line at height d
// over edge a:
//
//   the line of f: let O be where the lines of a and f meet, t0 and τ0 the coordinates of O along a
//   and f, and θ the angle from a to f. The offset lines meet at t0 − d·tan(θ/2) on a and
//   τ0 + d·tan(θ/2) on f. The line on f's other side is met at t0 + d·cot(θ/2), τ0 + d·cot(θ/2).
//
//   an end of f: where that foot τ lies beyond f's end q, the circle about q counts. It is met at
//   s ± sqrt(h·(2d − h)), with s along a and h above a the coordinates of q. If h <= 0, q is behind
//   the line and never reaches it.
//
// For the arc about v, with c the height of v over f's line: the feet are ± sqrt(c·(2d − c)) from
// the foot of v. Where they lie beyond f's end q, the circles about v and q meet.
//
// t0, τ0, s, h and c are computed from exact integer crosses and dots, and rounded once: whether
// corners are convex, edges parallel or points on a line is decided right. Both elements that meet
// at an end compute it from the same numbers.
//
// What is covered at one depth is covered at all greater ones: the straight way from a point of an
// element back to its own site is nearest to that site all along. So depths are trimmed in
// ascending order, and an element of which nothing stayed is not looked at again.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/offsets/offset_input.h"   // OffsetInput
#include "core/offsets/offset_search.h"  // OffsetSearch
#include "core/offsets/offset_span.h"    // OffsetSpan, TrimmedPiece

namespace core {

class OffsetTrim {
 public:
  // Forgets what earlier depths covered. REQUIRES of the calls of trim() after it: these contours,
  // depths in ascending order.
  void start(const OffsetInput& contours);

  // Returns false when contours touch at a corner that raises an arc and were not mended yet.
  // COSTS: O(n · sites within 2d of what survives).
  [[nodiscard]] bool trim(const OffsetInput& contours, const OffsetSearch& search, double depth);

  // What survived, by element; an element's pieces follow one another in its direction.
  [[nodiscard]] std::span<TrimmedPiece> pieces() { return pieces_.all(); }
  // Element e's pieces are pieces()[first(e) … first(e + 1)).
  [[nodiscard]] std::int32_t first(OffsetSite element) const {
    return first_[static_cast<std::size_t>(element)];
  }

 private:
  // The element that is being trimmed: where its edge or corner starts, and the unit vector along
  // the edge or at the arc's middle.
  struct Frame {
    double x, y, ux, uy;
    std::int32_t index;
  };

  template <bool kWide>
  bool trim_all();
  template <bool kWide>
  void trim_line(std::int32_t index, std::span<const std::int32_t> near);
  template <bool kWide>
  void cut_line_by_chunk(const Frame& a, const OffsetChunk& chunk);
  template <bool kWide>
  void cut_line(const Frame& a, std::int32_t other);
  template <bool kWide>
  bool trim_arc(std::int32_t index, std::span<const std::int32_t> near);
  template <bool kWide>
  bool cut_arc_by_chunk(const Frame& v, const OffsetChunk& chunk);
  template <bool kWide>
  bool cut_arc(const Frame& v, std::int32_t other);
  void remove_from_arc(OffsetEnd from, OffsetEnd to);

  [[nodiscard]] const OffsetEdge& edge(std::int32_t i) const {
    return (*edges_)[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] const OffsetCorner& corner(std::int32_t i) const {
    return (*corners_)[static_cast<std::size_t>(i)];
  }
  // The site of the corner i, whichever contour it was written in.
  [[nodiscard]] OffsetSite corner_site(std::int32_t i) const { return 2 * corner(i).owner + 1; }

  const OffsetInput* contours_ = nullptr;
  const std::vector<OffsetEdge>* edges_ = nullptr;
  const std::vector<OffsetCorner>* corners_ = nullptr;
  const OffsetSearch* search_ = nullptr;
  double depth_ = 0;
  // The edge that covered an element last: likely the next element, too.
  std::int32_t last_coverer_ = -1;
  OffsetSpan span_;
  TrimmedPieces pieces_;
  std::vector<std::int32_t> first_;
  std::vector<std::uint8_t> covered_;  // by element: nothing is left, here and deeper
};

}  // namespace core
