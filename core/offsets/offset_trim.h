// Trims every offset element of a region's contours at one depth d: of an edge's line and of a
// reflex corner's arc only those points stay that no capsule covers.
//
// Each other edge f cuts one interval out of an element, because its capsule (all points nearer
// than d) is convex. Its ends, in closed form, for the line at height d over edge a:
//
//      the line of f: with O where the lines of a and f meet, t0 and τ0 its places along a and f,
//      θ the angle from a to f, the offset lines meet at t0 − d·tan(θ/2) on a, τ0 + d·tan(θ/2) on
//      f, and f's line across on its other side at t0 + d·cot(θ/2), τ0 + d·cot(θ/2);
//      where that foot τ lies beyond f's end q: the circle about q, at s ± sqrt(h·(2d − h)), with
//      (s, h) q's place along and above a. h <= 0: q is behind the line and never reaches it.
//
// and for the arc about v, at height c over f's line: feet at ± sqrt(c·(2d − c)) from v's own;
// where they lie beyond f's end q: where the circles about v and q meet.
//
// t0, τ0, s, h and c come from crosses and dots of exact integers, rounded once: convex or not,
// parallel or not, on the line or not is decided right. Both elements that meet at an end compute
// it from the same numbers.
//
// What is covered at one depth is covered at all greater ones: the straight way from a point of an
// element back to its own site is nearest to that site all along. So depths are trimmed in
// ascending order, and an element of which nothing stayed is never looked at again.
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
  // Elements covered at the depths of earlier calls are left out: REQUIRES that none was greater,
  // nor of other contours, since begin().
  void begin(const OffsetInput& contours);

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
  std::int32_t killer_ = -1;  // the edge that covered an element last: likely the next one's too
  OffsetSpan span_;
  TrimmedPieces pieces_;
  std::vector<std::int32_t> first_;
  std::vector<std::uint8_t> covered_;  // by element: nothing is left, here and deeper
};

}  // namespace core
